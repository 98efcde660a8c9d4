// Writes a mesh as a STEP or BREP file, in these steps: partition, model, file, check, final name.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <tbb/task_arena.h>

#include <filesystem>
#include <functional>
#include <memory>

#include "base/number_text.h"
#include "base/safe_file.h"
#include "base/threads.h"
#include "base/timer.h"
#include "solid/mesh/half_edge.h"
#include "solid/model/judge.h"
#include "solid/reread.h"
#include "solid/solid_build.h"
#include "solid/solid_findings.h"
#include "solid/text/tessellated.h"
#include "solid/text_judge.h"
#include "swept/solid.h"

namespace swept {
namespace {

using namespace step;

[[noreturn]] void refuse(const char* code, const std::string& why, const std::string& what) {
  throw Error(
      Status::ExportFailed, code,
      "the solid was not saved, because its file " + why + ": " + what +
          ". If a file with this name existed, it is unchanged. Change the tolerance, or export "
          "a mesh file");
}

// Reads the file back with the judge. Throws an error with advice if the file cannot be read, or if
// it does not contain the solid of the mesh.
SolidCheck readBack(Judge& judge, const Built& built, const SafeFile& file, const std::string& name,
                    const HalfEdgeMesh& mesh, const SolidOptions& options, RunContext& run) {
  SolidCheck check;
  try {
    check = judge.readBack(built.model, file.temporary(), name, options,
                           solidFormatOf(file.target()), run);
  } catch (const Error& error) {
    if (error.code() != "RereadFailed") throw;
    refuse("RereadFailed", "cannot be read back", error.what());
  }
  const std::string what = rereadComplaint(check, mesh, options, built.meshError);
  if (!what.empty())
    refuse("RereadDiffers", "contained a different solid when it was read back", what);
  return check;
}

// Adds a note to the report if the solid deviates from the mesh by more than the tolerance.
void noteDeviation(WrittenSolid& report) {
  if (!(report.tolerance > 0 && report.deviation > report.tolerance)) return;
  if (!report.note.empty()) report.note += "; ";
  report.note += "the solid deviates from the mesh by up to " + numberText(report.deviation, 4) +
                 " mm, which is more than the tolerance of " + numberText(report.tolerance, 4) +
                 " mm; a smaller tolerance may reduce the deviation";
}

using Open = std::function<std::unique_ptr<Judge>()>;

WrittenSolid writeChecked(const TriMesh& input, const std::string& path, SolidOptions& options,
                          const Open& open, RunContext& run) {
  const SolidFormat format = solidFormatOf(path);
  SafeFile file(path);
  Timer watch;
  WrittenSolid report;
  const HalfEdgeMesh mesh = buildHalfEdges(input, run);
  const std::unique_ptr<Judge> judge = open();
  withJudge(*judge, mesh.triangles.size(), run, [&] {
    const double requested = options.tolerance;
    const Built built = buildWithinLimits(mesh, options, format, *judge, run);
    if (options.tolerance < requested) {
      report.note = "within a tolerance of " + numberText(requested, 3) +
                    " mm, parts of the surface would turn inside out; the solid was made with a "
                    "tolerance of " +
                    numberText(options.tolerance, 3) + " mm";
    }
    report.secondsBuild = watch.lap();
    const std::string name = utf8FromPath(pathFromUtf8(file.target()).filename());
    writeBuilt(built, *judge, file.stream(), name, options, format, run);
    file.close();
    report.secondsWrite = watch.lap();
    const SolidCheck check = readBack(*judge, built, file, name, mesh, options, run);
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

WrittenSolid writeOrFacets(const TriMesh& mesh, const std::string& path,
                           const SolidOptions& options, const Open& open, RunContext& run) {
  if (options.schema == StepSchema::Ap242Tessellated && solidFormatOf(path) == SolidFormat::Step)
    return writeTessellated(mesh, path, options, run);
  std::string why;
  WrittenSolid report = orFacets(
      options, why, [&](SolidOptions& used) { return writeChecked(mesh, path, used, open, run); });
  if (!why.empty())
    report.note = "the solid has no curved surfaces, because an attempt with them failed: " + why;
  return report;
}

WrittenSolid writeAny(const TriMesh& mesh, const std::string& path, const SolidOptions& options,
                      const Open& open, RunContext& run) {
  checkOptions(options);
  tbb::task_arena arena(threadsOf(run));
  WrittenSolid report =
      arena.execute([&] { return writeOrFacets(mesh, path, options, open, run); });
  report.warnings = solidFindings(report, options);
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

WrittenSolid writeSolid(const TriMesh& mesh, const std::string& path, const SolidOptions& options,
                        RunContext& run) {
  return writeAny(mesh, path, options, openJudge, run);
}

WrittenSolid writeSolid(const TriMesh& mesh, const std::string& path, const SolidOptions& options,
                        StepReader& reader, RunContext& run) {
  const auto judge = [&]() -> std::unique_ptr<Judge> {
    if (solidFormatOf(path) != SolidFormat::Brep) return std::make_unique<TextJudge>(reader);
    throw Error(Status::ExportFailed, "NoKernel",
                "a BREP file needs a geometry kernel, which this build does not have; write a STEP "
                "file");
  };
  return writeAny(mesh, path, options, judge, run);
}

}  // namespace swept
