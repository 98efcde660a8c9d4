// Writes a mesh as a STEP or BREP file: partition, model, kernel shape, file, check, final name.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <tbb/task_arena.h>

#include <filesystem>

#include "base/number_text.h"
#include "base/safe_file.h"
#include "base/threads.h"
#include "base/timer.h"
#include "solid/kernel/kernel.h"
#include "solid/kernel/shape_check.h"
#include "solid/kernel/solid_file.h"
#include "solid/mesh/half_edge.h"
#include "solid/reread.h"
#include "solid/solid_build.h"
#include "solid/solid_findings.h"
#include "solid/text/step_text.h"
#include "solid/text/tessellated.h"
#include "swept/solid.h"

namespace swept {
namespace {

using namespace step;

void compare(const SolidCheck& check, const HalfEdgeMesh& mesh, const StepOptions& options) {
  const std::string what = rereadComplaint(check, mesh, options);
  if (what.empty()) return;
  throw Error(Status::ExportFailed, "RereadDiffers",
              "the file was written, but reading it back gave a different result: " + what +
                  "; an existing file was kept. Change the tolerance, or export a mesh file");
}

// Adds a note to the report if the solid deviates from the mesh by more than its tolerance.
void noteDeviation(StepReport& report) {
  if (!(report.tolerance > 0 && report.deviation > report.tolerance)) return;
  if (!report.note.empty()) report.note += "; ";
  report.note += "the solid deviates from the mesh by up to " + numberText(report.deviation, 4) +
                 " mm, which is more than the tolerance of " + numberText(report.tolerance, 4) +
                 " mm; a smaller tolerance may reduce the deviation";
}

// The kernel reads plane faces without healing them if their vertices and edges lie within this
// distance (mm) of their planes.
constexpr double kExact = 1e-5;

StepReport writeChecked(const TriMesh& input, const std::string& path, StepOptions& options,
                        RunContext& run) {
  const SolidFormat format = solidFormatOf(path);
  SafeFile file(path);
  Timer watch;
  StepReport report;
  const HalfEdgeMesh mesh = buildHalfEdges(input, run);
  KernelSession kernel;
  withKernel(kernel, mesh.triangles.size(), run, [&] {
    const double asked = options.tolerance;
    const Built built = buildWithinLimits(mesh, options, format, kernel, run);
    if (options.tolerance < asked) {
      report.note = "within a tolerance of " + numberText(asked, 3) +
                    " mm, parts of the surface would turn inside out; the solid was made with a "
                    "tolerance of " +
                    numberText(options.tolerance, 3) + " mm";
    }
    report.secondsBuild = watch.lap();
    const std::string name = utf8FromPath(pathFromUtf8(file.target()).filename());
    writeBuilt(built, file.stream(), name, options, format, run);
    file.close();
    report.secondsWrite = watch.lap();
    const auto readBack = [&]() {
      if (format == SolidFormat::Brep) return readBrepFile(file.temporary(), run);
      const double accuracy = statedAccuracy(built.model);
      if (isFlat(built.model) && accuracy <= kExact)
        return readFlatStepFile(file.temporary(), accuracy, kernel, run);
      return readMostlyFlatStepFile(file.temporary(), kernel, run);
    };
    SolidCheck check = checkShape(readBack(), run, 0.8, 1.0);
    if (!check.valid && format == SolidFormat::Step)
      check = checkShape(readStepFile(file.temporary(), kernel, run), run, 0.8, 1.0);
    if (!check.valid && format == SolidFormat::Step && !isFlat(built.model)) {
      // Some curved faces read back wrong without parameter curves. The writer of the kernel adds
      // them.
      writeStepFile(built.brep.shape, file.temporary(), name, options, kernel, run);
      check = checkShape(readStepFile(file.temporary(), kernel, run), run, 0.8, 1.0);
    }
    compare(check, mesh, options);
    report.facesByKind.assign(built.facesByKind.begin(), built.facesByKind.end());
    report.deviation = built.deviation;
    report.tolerance = options.tolerance;
    report.edgeTolerance = check.edgeTolerance;
    if (options.strict && report.tolerance > 0 && report.deviation > report.tolerance) {
      throw Error(Status::ExportFailed, "SolidInaccurate",
                  "the solid would deviate from the mesh by " + numberText(report.deviation, 3) +
                      " mm, more than the tolerance of " + numberText(report.tolerance, 3) +
                      " mm; give a smaller tolerance, or make plane faces only");
    }
    noteDeviation(report);
    report.faces = check.faces;
    report.edges = check.edges;
    report.solids = check.solids;
    report.valid = check.valid;
    report.volume = check.volume;
    report.meshVolume = mesh.volume;
    report.secondsReread = watch.lap();
  });
  run.checkpoint(Phase::Export, 1, 1);
  report.fileBytes = file.commit();
  return report;
}

StepReport writeOrFacets(const TriMesh& mesh, const std::string& path, const StepOptions& options,
                         RunContext& run) {
  if (options.schema == StepSchema::Ap242Tessellated && solidFormatOf(path) == SolidFormat::Step)
    return writeTessellated(mesh, path, options, run);
  std::string why;
  StepReport report = orFacets(
      options, why, [&](StepOptions& used) { return writeChecked(mesh, path, used, run); });
  if (!why.empty())
    report.note = "the solid has no curved surfaces, because with curved surfaces " + why;
  return report;
}

}  // namespace

StepSchema parseStepSchema(const std::string& text) {
  if (text == "ap214") return StepSchema::Ap214;
  if (text == "ap242") return StepSchema::Ap242;
  if (text == "ap242-tessellated") return StepSchema::Ap242Tessellated;
  throw Error(Status::InvalidInput, "BadOption",
              "schema is '" + text + "'; allowed: ap214, ap242, ap242-tessellated");
}

StepReport writeSolid(const TriMesh& mesh, const std::string& path, const StepOptions& options,
                      RunContext& run) {
  checkOptions(options);
  tbb::task_arena arena(threadsOf(run));
  StepReport report = arena.execute([&] { return writeOrFacets(mesh, path, options, run); });
  report.warnings = solidFindings(report, options);
  return report;
}

}  // namespace swept
