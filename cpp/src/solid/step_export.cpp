// Mesh -> STEP or BREP file: partition, model, kernel shape, file, check, rename.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <tbb/task_arena.h>

#include <Eigen/Geometry>
#include <Standard_ErrorHandler.hxx>
#include <Standard_Failure.hxx>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <ios>
#include <map>
#include <new>
#include <optional>

#include "base/limits.h"
#include "base/number_text.h"
#include "base/parallel.h"
#include "base/safe_file.h"
#include "base/threads.h"
#include "base/timer.h"
#include "simplify/thin.h"
#include "solid/kernel/kernel.h"
#include "solid/kernel/shape_check.h"
#include "solid/kernel/shape_maker.h"
#include "solid/kernel/solid_file.h"
#include "solid/mesh/half_edge.h"
#include "solid/mesh/patches.h"
#include "solid/solid_findings.h"
#include "solid/text/step_text.h"
#include "solid/text/tessellated.h"
#include "swept/solid.h"

namespace swept {
namespace {

using namespace step;

enum class Format { Step, Brep };

Format formatOf(const std::string& path) {
  const std::string suffix = suffixOf(path);
  if (suffix == "step" || suffix == "stp") return Format::Step;
  if (suffix == "brep" || suffix == "brp") return Format::Brep;
  throw Error(
      Status::ExportFailed, "BadSuffix",
      "'" + path + "' does not end in .step, .stp, .brep or .brp, so the format is unknown");
}

[[noreturn]] void badOption(const std::string& text) {
  throw Error(Status::ExportFailed, "BadOption", text);
}

void requireLength(const char* name, double value) {
  if (value >= 0 && value <= kLargestLength) return;
  badOption(std::string(name) + " is " + numberText(value, kTellingDigits) +
            " mm; allowed: 0 to 1e9 mm");
}

// The kernel, and therefore most programs, fails on longer names.
constexpr std::size_t kLongestName = 1000;

void requireName(const char* name, const std::string& text) {
  if (text.size() <= kLongestName) return;
  badOption(std::string(name) + " has " + std::to_string(text.size()) + " bytes; allowed: up to " +
            std::to_string(kLongestName));
}

void checkOptions(const StepOptions& options) {
  requireLength("planarTolerance", options.planarTolerance);
  requireLength("the solid's tolerance", options.tolerance);
  requireName("the product's name", options.productName);
  requireName("the author", options.author);
  requireName("the organization", options.organization);
  for (const double part : options.colour) {
    if (!(part >= 0 && part <= 1))
      badOption("a part of the colour is " + numberText(part, kTellingDigits) +
                "; allowed: 0 to 1");
  }
  if (options.exact && options.tolerance > 0) {
    badOption("an exact solid has a tolerance of 0 mm");
  }
  if (!(options.maxMegabytes >= 0) || options.maxFaces < 4) {
    badOption("a solid has 4 faces at least, and a file more than 0 MB");
  }
}

// Rough figures, measured on triangulated bodies.
constexpr double kStepBytesPerFace = 750, kBrepBytesPerFace = 700, kBytesByCorners = 340;
constexpr double kSecondsPerFace = 3e-4, kSecondsPerTriangle = 8e-6, kSecondsAsItIs = 2e-6;

// What decides how many bytes a face takes in the file.
struct Writing {
  Format format = Format::Step;
  // Plane faces only, no hollow spaces: large numbers are written by their corners.
  bool flat = false;
};

Writing writingOf(const HalfEdgeMesh& mesh, const StepOptions& options, Format format) {
  const bool hollow = countOuterShells(mesh.shellOwner) < std::ssize(mesh.shellOwner);
  return {format, !hollow && (options.tolerance <= 0 || !options.recognise)};
}

double megabytesOf(std::int64_t faces, const Writing& writing) {
  const bool corners = writing.flat && faces >= kManyFaces;
  const double bytes = writing.format == Format::Brep ? kBrepBytesPerFace
                       : corners                      ? kBytesByCorners
                                                      : kStepBytesPerFace;
  return 1e-6 * static_cast<double>(faces) * bytes;
}

bool isWithinLimits(std::int64_t faces, const StepOptions& options, const Writing& writing) {
  return faces <= options.maxFaces &&
         (options.maxMegabytes <= 0 || megabytesOf(faces, writing) <= options.maxMegabytes);
}

[[noreturn]] void refuseTooMany(std::int64_t faces, const StepOptions& options,
                                const Writing& writing) {
  std::string limit = "the limit is " + std::to_string(options.maxFaces) + " faces";
  if (options.maxMegabytes > 0) limit += " and " + numberText(options.maxMegabytes, 3) + " MB";
  throw Error(
      Status::ExportFailed, "TooManyFaces",
      "the solid would have " + std::to_string(faces) + " faces at a tolerance of " +
          numberText(options.tolerance, 3) + " mm; " + limit + "; the file would take about " +
          fixedText(megabytesOf(faces, writing), 1) + " MB and " +
          std::to_string(
              static_cast<std::int64_t>(std::ceil(kSecondsPerFace * static_cast<double>(faces)))) +
          " s. " +
          (options.exact ? "It may not leave the mesh (exact), so take larger cells or raise the "
                           "limit of faces"
                         : "Allow a larger tolerance, raise the limit") +
          ", or export a mesh file: PLY, STL, OBJ, OFF or 3MF hold it easily");
}

// Fraction of the tolerance, for thinning a dense mesh before surfaces are recognised.
constexpr double kThinFraction = 0.15;
constexpr std::size_t kDense = 150000;  // triangles; a smaller mesh is not thinned first

double diagonalOf(const HalfEdgeMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : mesh.points) box.extend(p);
  return box.diagonal().norm();
}

HalfEdgeMesh thinned(const HalfEdgeMesh& mesh, double limit, RunContext& run) {
  return buildHalfEdges(
      thinOut({mesh.points, mesh.triangles}, limit, ThinFor::Surfaces, Phase::Export, run).mesh,
      run);
}

// Builds with the given tolerance, or with the smallest of a series that meets the limits;
// `options` then contains it.
Built buildWithinLimits(const HalfEdgeMesh& mesh, StepOptions& options, Format format,
                        KernelSession& kernel, RunContext& run) {
  const auto fits = [&](std::int64_t count) {
    return isWithinLimits(count, options, writingOf(mesh, options, format));
  };
  constexpr double kFirst = 1.0 / 4000, kMax = 1.0 / 100;  // of the diagonal
  const bool given = options.tolerance > 0;
  std::int64_t faces = 0;
  if (!given) {
    if (auto built = makeShape(mesh, mesh, options, fits, kernel, faces, run))
      return std::move(*built);
    if (options.exact) refuseTooMany(faces, options, writingOf(mesh, options, format));
  }
  const double diagonal = diagonalOf(mesh);
  HalfEdgeMesh thin;
  const HalfEdgeMesh* dense = &mesh;
  if (!given) options.tolerance = kFirst * diagonal;
  for (;; options.tolerance *= 2) {
    if (dense->triangles.size() > kDense) {
      // Continue with the result of the last round, whose part of the tolerance was half as large.
      thin = thinned(*dense, kThinFraction * options.tolerance, run);
      dense = &thin;
    }
    if (auto built = makeShape(mesh, *dense, options, fits, kernel, faces, run))
      return std::move(*built);
    if (given || 2 * options.tolerance > kMax * diagonal)
      refuseTooMany(faces, options, writingOf(mesh, options, format));
  }
}

// If the tolerance is as large as the body, its surface may turn inside out; then try half of it.
template <class Work>
auto uprightWithin(double& tolerance, const Work& work) {
  constexpr int kHalvings = 8;
  for (int n = 0;; ++n) {
    try {
      return work();
    } catch (const Error& error) {
      if (error.code() != "InvertedShell" || n == kHalvings) throw;
      tolerance /= 2;
    }
  }
}

void compare(const SolidCheck& check, const HalfEdgeMesh& mesh, const StepOptions& options) {
  const std::int64_t outer = countOuterShells(mesh.shellOwner);
  const double allowed = mesh.area * std::max(options.planarTolerance, options.tolerance) +
                         1e-6 * std::abs(mesh.volume);
  std::string what;
  if (!check.valid) {
    what = check.complaint;
  } else if (check.solids != outer || check.shells != std::ssize(mesh.shellOwner)) {
    what = std::to_string(check.solids) + " solids with " + std::to_string(check.shells) +
           " shells instead of " + std::to_string(outer) + " with " +
           std::to_string(mesh.shellOwner.size());
  } else if (!(std::abs(check.volume - mesh.volume) <= allowed)) {
    what = "volume " + numberText(check.volume, 9) + " mm^3 instead of " +
           numberText(mesh.volume, 9) + " mm^3 (allowed difference " + numberText(allowed, 3) + ")";
  } else if (options.tolerance > 0 && options.recognise &&
             check.edgeTolerance > options.tolerance) {
    what = "an edge or vertex with a tolerance of " + numberText(check.edgeTolerance, 3) +
           " mm, more than the solid's of " + numberText(options.tolerance, 3) + " mm";
  }
  if (!what.empty()) {
    throw Error(Status::ExportFailed, "RereadDiffers",
                "the file was written but reads back wrong: " + what +
                    "; the target was left as it was. Export a mesh file or change the tolerance");
  }
}

// A promise that is not kept must be seen.
void noteDeviation(StepReport& report) {
  if (!(report.tolerance > 0 && report.deviation > report.tolerance)) return;
  if (!report.note.empty()) report.note += "; ";
  report.note += "the solid lies up to " + numberText(report.deviation, 4) +
                 " mm from the mesh, above the tolerance of " + numberText(report.tolerance, 4) +
                 " mm; a smaller tolerance may keep it nearer";
}

constexpr double kExact =
    1e-5;  // mm: plane faces that meet this well need no mending by the kernel

bool isWorthFacets(const Error& error) {
  return error.status() == Status::ExportFailed &&
         (error.code() == "InvalidFaces" || error.code() == "RereadDiffers" ||
          error.code() == "RereadFailed" || error.code() == "KernelFailure" ||
          error.code() == "SolidInaccurate");
}

StepReport writeChecked(const TriMesh& input, const std::string& path, StepOptions& options,
                        RunContext& run) {
  const Format format = formatOf(path);
  SafeFile file(path);
  Timer watch;
  StepReport report;
  const HalfEdgeMesh mesh = buildHalfEdges(input, run);
  KernelSession kernel;
  try {
    OCC_CATCH_SIGNALS
    const double asked = options.tolerance;
    const Built built = uprightWithin(
        options.tolerance, [&] { return buildWithinLimits(mesh, options, format, kernel, run); });
    if (options.tolerance < asked) {
      report.note = "within a tolerance of " + numberText(asked, 3) +
                    " mm the surface would turn inside out; it was made within " +
                    numberText(options.tolerance, 3) + " mm";
    }
    report.secondsBuild = watch.lap();
    const std::string name = utf8FromPath(pathFromUtf8(file.target()).filename());
    if (format == Format::Brep) {
      writeBrep(built.brep.shape, file.stream(), run);
    } else {
      writeStepText(built.model, file.stream(), name, options, run);
    }
    file.close();
    report.secondsWrite = watch.lap();
    const auto readBack = [&]() {
      if (format == Format::Brep) return readBrepFile(file.temporary(), run);
      const double accuracy = statedAccuracy(built.model);
      if (isFlat(built.model) && accuracy <= kExact)
        return readFlatStepFile(file.temporary(), accuracy, kernel, run);
      return readMostlyFlatStepFile(file.temporary(), kernel, run);
    };
    SolidCheck check = checkShape(readBack(), run, 0.8, 1.0);
    if (!check.valid && format == Format::Step)
      check = checkShape(readStepFile(file.temporary(), kernel, run), run, 0.8, 1.0);
    if (!check.valid && format == Format::Step && !isFlat(built.model)) {
      // Some curved faces need their parameter curves in the file, which the kernel adds.
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
                  "the solid would leave the mesh by " + numberText(report.deviation, 3) +
                      " mm, more than the tolerance of " + numberText(report.tolerance, 3) +
                      " mm; give a smaller tolerance, or plane faces only");
    }
    noteDeviation(report);
    report.faces = check.faces;
    report.edges = check.edges;
    report.solids = check.solids;
    report.valid = check.valid;
    report.volume = check.volume;
    report.meshVolume = mesh.volume;
    report.secondsReread = watch.lap();
  } catch (const Standard_Failure& failure) {
    run.checkpoint(Phase::Export);  // a cancelled kernel call may end in an exception of its own
    const char* text = failure.GetMessageString();
    throw Error(Status::ExportFailed, "KernelFailure",
                std::string("the geometry kernel failed: ") + failure.DynamicType()->Name() +
                    (text != nullptr && *text != 0 ? std::string(": ") + text : std::string()) +
                    (kernel.messages().empty() ? std::string() : " (" + kernel.messages() + ")"));
  } catch (const std::bad_alloc&) {
    throw Error(Status::OutOfMemory, "OutOfMemory",
                "the memory did not suffice for the solid of a mesh of " +
                    std::to_string(mesh.triangles.size()) +
                    " triangles; simplify the envelope or export a mesh file");
  } catch (const std::ios_base::failure& failure) {
    throw Error(Status::ExportFailed, "WriteFailed",
                std::string("writing failed: ") + failure.what());
  }
  run.checkpoint(Phase::Export, 1, 1);
  report.fileBytes = file.commit();
  return report;
}

SolidEstimate estimateChecked(const TriMesh& mesh, const StepOptions& options, RunContext& run) {
  const HalfEdgeMesh whole = buildHalfEdges(mesh, run);
  SolidEstimate estimate;
  estimate.triangles = static_cast<std::int64_t>(whole.triangles.size());
  if (options.schema == StepSchema::Ap242Tessellated) {
    estimate.faces = estimate.triangles;
    estimate.megabytes = tessellatedMegabytes(estimate.faces);
    estimate.seconds = kSecondsAsItIs * static_cast<double>(estimate.triangles);
    return estimate;
  }
  if (options.tolerance > 0) {
    double tolerance = options.tolerance;
    estimate.faces = static_cast<std::int64_t>(
        uprightWithin(tolerance, [&] { return thinned(whole, tolerance, run); }).triangles.size());
  } else {
    Partition partition;
    partition.patchOf.assign(whole.triangles.size(), -1);
    if (options.mergeCoplanar) growPlanes(whole, options.planarTolerance, partition, run);
    estimate.faces =
        static_cast<std::int64_t>(partition.patches.size()) +
        std::count(partition.patchOf.begin(), partition.patchOf.end(), std::int32_t{-1});
  }
  estimate.megabytes = megabytesOf(estimate.faces, writingOf(whole, options, Format::Step));
  estimate.seconds = kSecondsPerFace * static_cast<double>(estimate.faces) +
                     kSecondsPerTriangle * static_cast<double>(estimate.triangles);
  return estimate;
}

StepReport writeOrFacets(const TriMesh& mesh, const std::string& path, const StepOptions& options,
                         RunContext& run) {
  if (options.schema == StepSchema::Ap242Tessellated && formatOf(path) == Format::Step)
    return writeTessellated(mesh, path, options, run);
  StepOptions used = options;
  try {
    return writeChecked(mesh, path, used, run);
  } catch (const Error& error) {
    if (used.tolerance <= 0 || !options.recognise || !isWorthFacets(error)) throw;
    // An export never fails for the sake of nicer surfaces: try again with simplified facets only.
    used.recognise = false;
    StepReport report = writeChecked(mesh, path, used, run);
    report.note = std::string("no surfaces were recognised, because with them ") + error.what();
    return report;
  }
}

}  // namespace

StepSchema parseStepSchema(const std::string& text) {
  if (text == "ap214") return StepSchema::Ap214;
  if (text == "ap242") return StepSchema::Ap242;
  if (text == "ap242-tessellated") return StepSchema::Ap242Tessellated;
  throw Error(Status::InvalidInput, "BadOption",
              "schema is '" + text + "'; allowed: ap214, ap242, ap242-tessellated");
}

SolidEstimate estimateSolid(const TriMesh& mesh, const StepOptions& options, RunContext& run) {
  checkOptions(options);
  tbb::task_arena arena(threadsOf(run));
  return arena.execute([&] { return estimateChecked(mesh, options, run); });
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
