// The way from a mesh to a file: partition, model, kernel shape, file, check, rename.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "swept/step_export.h"

#include <Standard_ErrorHandler.hxx>
#include <Standard_Failure.hxx>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <ios>
#include <map>
#include <new>

#include "brep.h"
#include "decimate.h"
#include "half_edge.h"
#include "kernel.h"
#include "model.h"
#include "patches.h"
#include "recognise.h"
#include "solid_file.h"
#include "target_file.h"

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

void checkOptions(const StepOptions& options) {
  if (options.schema != "AP214IS" && options.schema != "AP242DIS" && options.schema != "AP203") {
    throw Error(Status::ExportFailed, "BadOption",
                "schema is '" + options.schema + "'; allowed: AP214IS, AP242DIS, AP203");
  }
  if (!(options.planarTolerance >= 0) || !std::isfinite(options.planarTolerance)) {
    throw Error(Status::ExportFailed, "BadOption", "planarTolerance must be 0 mm or more");
  }
}

std::string number(const char* format, double value) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, format, value);
  return buffer;
}

// Rough figures of this kernel, measured on triangulated bodies: bytes and seconds a face.
constexpr double kStepBytesPerFace = 2450, kBrepBytesPerFace = 700;
constexpr double kStepSecondsPerFace = 1.5e-3, kBrepSecondsPerFace = 3e-4;

void refuseTooMany(std::int64_t faces, std::int64_t limit, Format format) {
  if (faces <= limit) return;
  const bool isStep = format == Format::Step;
  const double bytes =
      static_cast<double>(faces) * (isStep ? kStepBytesPerFace : kBrepBytesPerFace);
  const double seconds =
      static_cast<double>(faces) * (isStep ? kStepSecondsPerFace : kBrepSecondsPerFace);
  throw Error(
      Status::ExportFailed, "TooManyFaces",
      "the solid would have " + std::to_string(faces) + " faces, the limit is " +
          std::to_string(limit) + "; the file would take about " + number("%.0f", bytes / 1e6) +
          " MB and " + number("%.0f", seconds) +
          " s. Simplify the envelope (a tolerance in mm), raise the limit, or export a mesh "
          "file: PLY, STL, OBJ, OFF or 3MF hold it easily");
}

class Stopwatch {
 public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - last_).count();
    last_ = now;
    return seconds;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

struct Built {
  Brep brep;
  std::map<std::string, std::int64_t> facesByKind;
  double deviation = 0;  // mm, of the mesh's vertices from their faces
};

Built describe(Brep brep, const Model& model, const Decimated& small) {
  Built built{std::move(brep), {}, small.deviation + model.facetShift};
  for (const ModelFace& face : model.faces) {
    ++built.facesByKind[surfaceKindName(face.surface.kind)];
    built.deviation = std::max(built.deviation, small.partition.patches[face.patch].deviation);
  }
  return built;
}

Partition partitionOf(const HalfEdgeMesh& mesh, const StepOptions& options, RunContext& run) {
  Partition partition;
  partition.patchOf.assign(mesh.triangles.size(), -1);
  if (options.tolerance > 0 && options.recognise) {
    recogniseSurfaces(mesh, options.tolerance, partition, run);
  }
  return partition;
}

// Patches that the kernel refused become open ground again.
void forgetPatches(const std::vector<std::int32_t>& patches, Partition& partition) {
  for (const std::int32_t p : patches) {
    for (const std::int32_t t : partition.patches[p].triangles) partition.patchOf[t] = -1;
    partition.patches[p].triangles.clear();
  }
}

// The recognised patches in the fan of a half-edge's first vertex.
void addKnownAround(const Decimated& small, std::int32_t first, std::int32_t known,
                    std::vector<std::int32_t>& patches) {
  std::int32_t h = first;
  do {
    const std::int32_t patch = small.partition.patchOf[h / 3];
    if (patch < known) patches.push_back(patch);
    h = small.mesh.opposite[HalfEdgeMesh::previous(h)];
  } while (h != first);
}

// Builds the shape. Faces that the kernel refuses lose their surface and are built of facets.
Built buildValidBrep(const HalfEdgeMesh& whole, const StepOptions& options, Format format,
                     RunContext& run) {
  constexpr int kRounds = 5;
  const double tolerance = std::max(options.planarTolerance, options.tolerance);
  Partition recognised = partitionOf(whole, options, run);
  for (int round = 0;; ++round) {
    Decimated small{whole, recognised, 0};
    if (options.tolerance > 0) small = decimate(whole, recognised, options.tolerance, run);
    const auto known = static_cast<std::int32_t>(recognised.patches.size());
    if (options.mergeCoplanar)
      growPlanes(small.mesh, options.planarTolerance, small.partition, run);
    addFacets(small.mesh, small.partition);
    refuseTooMany(static_cast<std::int64_t>(small.partition.patches.size()), options.maxFaces,
                  format);
    std::vector<std::int32_t> refused;
    for (int inner = 0; inner < 3; ++inner) {
      const Model model = buildModel(small.mesh, small.partition, tolerance, run);
      Brep brep = buildBrep(model, run);
      std::vector<std::int32_t> bad = brep.failed;
      if (bad.empty()) bad = findBadFaces(brep.faces, run, 0.1, 0.3);
      if (bad.empty()) return describe(std::move(brep), model, small);
      refused.clear();
      bool again = false;
      for (const std::int32_t face : bad) {
        const std::int32_t patch = model.faces[face].patch;
        if (patch < known) {
          refused.push_back(patch);
        } else if (small.partition.patches[patch].triangles.size() > 1) {
          dissolvePatch(small.mesh, patch, small.partition);
          again = true;
        } else {
          // A facet fails because of what its neighbours made of its corners.
          const std::int32_t t = small.partition.patches[patch].triangles[0];
          for (int k = 0; k < 3; ++k) addKnownAround(small, 3 * t + k, known, refused);
        }
      }
      if (!refused.empty() || !again) break;
    }
    std::sort(refused.begin(), refused.end());
    refused.erase(std::unique(refused.begin(), refused.end()), refused.end());
    if (refused.empty() || round == kRounds) {
      throw Error(
          Status::ExportFailed, "InvalidFaces",
          "some faces are not accepted by the kernel; the mesh may have needle triangles or "
          "intersect itself: simplify or repair it, or export a mesh file");
    }
    forgetPatches(refused, recognised);
  }
}

void compare(const ShapeCheck& check, const HalfEdgeMesh& mesh, const StepOptions& options) {
  std::int64_t outer = 0;
  for (std::size_t s = 0; s < mesh.shellOwner.size(); ++s) {
    outer += mesh.shellOwner[s] == static_cast<std::int32_t>(s);
  }
  const double allowed = mesh.area * std::max(options.planarTolerance, options.tolerance) +
                         1e-6 * std::abs(mesh.volume);
  std::string what;
  if (!check.valid) {
    what = check.complaint;
  } else if (check.solids != outer ||
             check.shells != static_cast<std::int64_t>(mesh.shellOwner.size())) {
    what = std::to_string(check.solids) + " solids with " + std::to_string(check.shells) +
           " shells instead of " + std::to_string(outer) + " with " +
           std::to_string(mesh.shellOwner.size());
  } else if (!(std::abs(check.volume - mesh.volume) <= allowed)) {
    what = "volume " + number("%.9g", check.volume) + " mm^3 instead of " +
           number("%.9g", mesh.volume) + " mm^3 (allowed difference " + number("%.3g", allowed) +
           ")";
  }
  if (!what.empty()) {
    throw Error(Status::ExportFailed, "RereadDiffers",
                "the file was written but reads back wrong: " + what +
                    "; the target was left as it was. Export a mesh file or change the tolerance");
  }
}

bool isWorthFacets(const Error& error) {
  return error.status() == Status::ExportFailed &&
         (error.code() == "InvalidFaces" || error.code() == "RereadDiffers" ||
          error.code() == "RereadFailed" || error.code() == "KernelFailure");
}

StepReport writeChecked(const TriMesh& input, const std::string& path, const StepOptions& options,
                        RunContext& run) {
  const Format format = formatOf(path);
  checkOptions(options);
  TargetFile file(path);
  Stopwatch watch;
  StepReport report;
  const HalfEdgeMesh mesh = buildHalfEdges(input, run);
  KernelSession kernel;
  try {
    OCC_CATCH_SIGNALS
    const Built built = buildValidBrep(mesh, options, format, run);
    report.secondsBuild = watch.lap();
    TopoDS_Shape back;
    if (format == Format::Step) {
      const auto name = std::filesystem::path(file.target()).filename().string();
      writeStepFile(built.brep.shape, file.temporary(), name, options, kernel, run);
      report.secondsWrite = watch.lap();
      back = readStepFile(file.temporary(), kernel, run);
    } else {
      writeBrepFile(built.brep.shape, file.temporary(), run);
      report.secondsWrite = watch.lap();
      back = readBrepFile(file.temporary(), run);
    }
    const ShapeCheck check = checkShape(back, run, 0.8, 1.0);
    compare(check, mesh, options);
    report.facesByKind.assign(built.facesByKind.begin(), built.facesByKind.end());
    report.deviation = built.deviation;
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

}  // namespace

StepReport writeSolid(const TriMesh& mesh, const std::string& path, const StepOptions& options,
                      RunContext& run) {
  try {
    return writeChecked(mesh, path, options, run);
  } catch (const Error& error) {
    if (options.tolerance <= 0 || !options.recognise || !isWorthFacets(error)) throw;
    // Never a failed export for the sake of nicer surfaces: once more with simplified facets only.
    StepOptions plain = options;
    plain.recognise = false;
    StepReport report = writeChecked(mesh, path, plain, run);
    report.note = std::string("no surfaces were recognised, because with them ") + error.what();
    return report;
  }
}

}  // namespace swept
