// The way from a mesh to a file: partition, model, kernel shape, file, check, rename.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "swept/step_export.h"

#include <Eigen/Geometry>
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
#include <optional>

#include "base/parallel.h"
#include "base/safe_file.h"
#include "brep.h"
#include "decimate.h"
#include "deviation.h"
#include "half_edge.h"
#include "kernel.h"
#include "model.h"
#include "patches.h"
#include "recognise.h"
#include "shape_check.h"
#include "simplify/nearest_triangle.h"
#include "solid_file.h"
#include "step_text.h"
#include "thin.h"
#include "tidy_patches.h"

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
  if (!(options.planarTolerance >= 0) || !std::isfinite(options.planarTolerance)) {
    throw Error(Status::ExportFailed, "BadOption", "planarTolerance must be 0 mm or more");
  }
  if (!(options.tolerance >= 0) || !std::isfinite(options.tolerance)) {
    throw Error(Status::ExportFailed, "BadOption", "the solid's tolerance must be 0 mm or more");
  }
  if (options.exact && options.tolerance > 0) {
    throw Error(Status::ExportFailed, "BadOption", "an exact solid has a tolerance of 0 mm");
  }
  if (!(options.maxMegabytes >= 0) || options.maxFaces < 4) {
    throw Error(Status::ExportFailed, "BadOption",
                "a solid has 4 faces at least, and a file more than 0 MB");
  }
}

std::string number(const char* format, double value) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, format, value);
  return buffer;
}

// Rough figures of one core, measured on triangulated bodies.
constexpr double kStepBytesPerFace = 750, kBrepBytesPerFace = 700;
constexpr double kSecondsPerFace = 3e-4, kSecondsPerTriangle = 8e-6;

double megabytesOf(std::int64_t faces, Format format) {
  return 1e-6 * static_cast<double>(faces) *
         (format == Format::Step ? kStepBytesPerFace : kBrepBytesPerFace);
}

bool isWithinLimits(std::int64_t faces, const StepOptions& options, Format format) {
  return faces <= options.maxFaces &&
         (options.maxMegabytes <= 0 || megabytesOf(faces, format) <= options.maxMegabytes);
}

[[noreturn]] void refuseTooMany(std::int64_t faces, const StepOptions& options, Format format) {
  std::string limit = "the limit is " + std::to_string(options.maxFaces) + " faces";
  if (options.maxMegabytes > 0) limit += " and " + number("%.3g", options.maxMegabytes) + " MB";
  throw Error(Status::ExportFailed, "TooManyFaces",
              "the solid would have " + std::to_string(faces) + " faces at a tolerance of " +
                  number("%.3g", options.tolerance) + " mm; " + limit +
                  "; the file would take about " + number("%.1f", megabytesOf(faces, format)) +
                  " MB and " +
                  number("%.0f", std::ceil(kSecondsPerFace * static_cast<double>(faces))) +
                  " s. Allow a larger tolerance, raise the limit, or export a mesh file: PLY, STL, "
                  "OBJ, OFF or 3MF hold it easily");
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
  Model model;
  Brep brep;
  std::map<std::string, std::int64_t> facesByKind;
  double deviation = 0;  // mm, of the mesh's vertices from their faces
};

Built describe(Model model, Brep brep, double deviation) {
  Built built{std::move(model), std::move(brep), {}, deviation};
  for (const ModelFace& face : built.model.faces)
    ++built.facesByKind[surfaceKindName(face.surface.kind)];
  return built;
}

// Of the tolerance: for the thinning before surfaces are looked for, for surfaces, and for facets.
// Where facets and thinning add up to more than the tolerance, the mesh gets more corners in the
// end.
constexpr double kThinShare = 0.15, kSurfaceShare = 0.83, kFaceShare = 0.95;

Partition partitionOf(const HalfEdgeMesh& mesh, const StepOptions& options, RunContext& run) {
  Partition partition;
  partition.patchOf.assign(mesh.triangles.size(), -1);
  if (options.tolerance > 0 && options.recognise) {
    recogniseSurfaces(mesh, kSurfaceShare * options.tolerance, partition, run);
  }
  return partition;
}

// Patches that the kernel refused become open ground again. Their borders may have moved on their
// surfaces: what is to stay near the triangles are the vertices that the mesh had there at first.
void forgetPatches(const std::vector<std::int32_t>& patches, const HalfEdgeMesh& dense,
                   const Partition& first, Decimated& now) {
  now.attached.resize(now.mesh.triangles.size());
  for (const std::int32_t p : patches) {
    std::vector<std::int32_t>& members = now.partition.patches[p].triangles;
    if (members.empty()) continue;
    NearestTriangle::Triangles open;
    for (const std::int32_t t : members) {
      now.partition.patchOf[t] = -1;
      open.push_back(now.mesh.triangles[t]);
    }
    std::vector<std::int32_t> vertices;
    for (const std::int32_t t : first.patches[p].triangles)
      vertices.insert(vertices.end(), dense.triangles[t].begin(), dense.triangles[t].end());
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    const NearestTriangle nearest(now.mesh.points, open);
    std::int32_t home = -1;
    for (const std::int32_t v : vertices) {
      nearest.query(dense.points[v], 1e300, 0, home);
      now.attached[members[home]].push_back(dense.points[v]);
    }
    members.clear();
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

constexpr std::size_t kDense = 150000;  // triangles; a smaller mesh is not thinned first

// Faces that the kernel refuses, as patches: recognised ones lose their surface, flat regions fall
// into facets. True if something was changed in `small` alone.
bool takeBack(const std::vector<std::int32_t>& bad, const Model& model, std::int32_t known,
              Decimated& small, std::vector<std::int32_t>& refused) {
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
  std::sort(refused.begin(), refused.end());
  refused.erase(std::unique(refused.begin(), refused.end()), refused.end());
  return again;
}

// Edges of open ground that a patch may cost for each facet that it saves: of a free form it has a
// long jagged border, and facets without it would be fewer.
constexpr double kBorderPerSaved = 1.5, kBorderPerSavedByPlane = 5;
constexpr double kSmooth = 0.85;  // cosine

// Patches whose border with open ground, as simplified, costs more facets than they save.
std::vector<std::int32_t> findCostly(const HalfEdgeMesh& dense, const Partition& first,
                                     const Decimated& now, double tolerance) {
  const std::size_t count = first.patches.size();
  std::vector<std::int32_t> border(count, 0), costly;
  for (std::size_t h = 0; h < now.mesh.opposite.size(); ++h) {
    const std::int32_t own = now.partition.patchOf[h / 3], beyond = now.mesh.opposite[h] / 3;
    if (own < 0 || now.partition.patchOf[beyond] >= 0) continue;
    // A crease needs its corners in any case.
    const Eigen::Vector3d normal = now.mesh.areaVector(beyond).normalized();
    const Eigen::Vector3d& from = now.mesh.points[now.mesh.origin(static_cast<std::int32_t>(h))];
    if (first.patches[own].surface.normal(from).dot(normal) > kSmooth) ++border[own];
  }
  const TriangleShapes shapes = shapesOf(dense);
  for (std::size_t p = 0; p < count; ++p) {
    const Patch& patch = first.patches[p];
    const double each = patch.surface.isPlanar() ? kBorderPerSavedByPlane : kBorderPerSaved;
    if (border[p] > each * facetsSaved(patch, shapes, tolerance))
      costly.push_back(static_cast<std::int32_t>(p));
  }
  return costly;
}

std::int64_t countFaces(const Partition& partition) {
  return std::count_if(partition.patches.begin(), partition.patches.end(),
                       [](const Patch& patch) { return !patch.triangles.empty(); });
}

// Builds the shape; nothing if it would have too many faces, whose number is then in `faces`.
// `dense` is the mesh, `whole` the mesh that the deviation is measured from.
class ShapeMaker {
 public:
  ShapeMaker(const HalfEdgeMesh& whole, const HalfEdgeMesh& dense, const StepOptions& options,
             Format format, RunContext& run)
      : whole_(whole), dense_(dense), options_(options), format_(format), run_(run) {}

  std::optional<Built> make(std::int64_t& faces) {
    constexpr int kRounds = 5;
    const Partition first = partitionOf(dense_, options_, run_);
    known_ = static_cast<std::int32_t>(first.patches.size());
    const double tolerance = kFaceShare * options_.tolerance;
    Decimated start{dense_, first, {}, {}, 0};
    if (known_ > 0 && worthTrial()) start.partition = tryOut(first, tolerance);
    for (int round = 0; round <= kRounds; ++round) {
      if (tolerance > 0) start = decimate(std::move(start), tolerance, run_);
      refused_.clear();
      if (auto built = tryMesh(start, faces)) return built;
      if (!isWithinLimits(faces, options_, format_)) return std::nullopt;
      if (refused_.empty()) break;
      forgetPatches(refused_, dense_, first, start);
    }
    throw Error(Status::ExportFailed, "InvalidFaces",
                "some faces are not accepted by the kernel; the mesh may have needle triangles or "
                "intersect itself: simplify or repair it, or export a mesh file");
  }

 private:
  bool worthTrial() const { return dense_.triangles.size() > kWorthTrial; }

  // Patches that are not worth their border and those that the kernel refuses show in a rough
  // simplification; without them the right one starts from ground that is open from the beginning.
  Partition tryOut(const Partition& first, double tolerance) {
    Decimated rough = decimateRoughly({dense_, first, {}, {}, 0}, tolerance, run_);
    std::vector<std::int32_t> bad = findCostly(dense_, first, rough, tolerance);
    addFacets(rough.mesh, rough.partition);
    const Model model = buildModel(rough.mesh, rough.partition, options_.tolerance, run_);
    const Brep brep = buildBrep(model, run_);
    std::vector<std::int32_t> faces = brep.failed;
    if (faces.empty()) faces = findBadFaces(brep.faces, run_, 0.05, 0.1);
    for (const std::int32_t face : faces) {
      if (model.faces[face].patch < known_) bad.push_back(model.faces[face].patch);
    }
    Partition left = first;
    for (const std::int32_t p : bad) {
      for (const std::int32_t t : first.patches[p].triangles) left.patchOf[t] = -1;
      left.patches[p].triangles.clear();
    }
    return left;
  }

  // Where the kernel takes offence, by falling apart into facets, and where the mesh is left by too
  // much, by more corners.
  std::optional<Built> tryMesh(Decimated base, std::int64_t& faces) {
    const double tolerance = std::max(options_.planarTolerance, options_.tolerance);
    for (int mended = 0;; ++mended) {
      Decimated small = base;
      if (options_.mergeCoplanar)
        growPlanes(small.mesh, options_.planarTolerance, small.partition, run_);
      addFacets(small.mesh, small.partition);
      faces = countFaces(small.partition);
      if (!isWithinLimits(faces, options_, format_)) return std::nullopt;
      std::optional<Model> model;
      Brep brep;
      for (int inner = 0; inner < 3 && !model; ++inner) {
        model = buildModel(small.mesh, small.partition, tolerance, run_);
        brep = buildBrep(*model, run_);
        std::vector<std::int32_t> bad = brep.failed;
        if (bad.empty()) bad = findBadFaces(brep.faces, run_, 0.1, 0.3);
        if (bad.empty()) break;
        const bool again = takeBack(bad, *model, known_, small, refused_);
        model.reset();
        if (!again || !refused_.empty()) return std::nullopt;
      }
      if (!model) return std::nullopt;
      const Deviation off = measureDeviation(whole_, small, model->places, tolerance);
      if (off.beyond.empty() || mended == kMendings || !putCorners(off.beyond, base, run_))
        return describe(std::move(*model), std::move(brep), off.largest);
    }
  }

  static constexpr int kMendings = 4;
  static constexpr std::size_t kWorthTrial = 20000;  // triangles
  const HalfEdgeMesh& whole_;
  const HalfEdgeMesh& dense_;
  const StepOptions& options_;
  Format format_;
  RunContext& run_;
  std::int32_t known_ = 0;             // patches below this one were recognised
  std::vector<std::int32_t> refused_;  // patches that are to lose their surface
};

double diagonalOf(const HalfEdgeMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : mesh.points) box.extend(p);
  return box.diagonal().norm();
}

// With the tolerance given, or with the smallest of a series that meets the limits; `options` then
// says which.
Built buildWithinLimits(const HalfEdgeMesh& mesh, StepOptions& options, Format format,
                        RunContext& run) {
  constexpr double kFirst = 1.0 / 4000, kMost = 1.0 / 100;  // of the diagonal
  const bool given = options.tolerance > 0;
  std::int64_t faces = 0;
  if (!given) {
    if (auto built = ShapeMaker(mesh, mesh, options, format, run).make(faces))
      return std::move(*built);
    if (options.exact) refuseTooMany(faces, options, format);
  }
  const double diagonal = diagonalOf(mesh);
  HalfEdgeMesh thin;
  const HalfEdgeMesh* dense = &mesh;
  if (!given) options.tolerance = kFirst * diagonal;
  for (;; options.tolerance *= 2) {
    if (dense->triangles.size() > kDense) {
      // From what the last round left: its part of the tolerance was half as large.
      thin = thinOut(*dense, kThinShare * options.tolerance, run);
      dense = &thin;
    }
    if (auto built = ShapeMaker(mesh, *dense, options, format, run).make(faces))
      return std::move(*built);
    if (given || 2 * options.tolerance > kMost * diagonal) refuseTooMany(faces, options, format);
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

constexpr double kExact =
    1e-5;  // mm: plane faces that meet this well need no mending by the kernel

bool isWorthFacets(const Error& error) {
  return error.status() == Status::ExportFailed &&
         (error.code() == "InvalidFaces" || error.code() == "RereadDiffers" ||
          error.code() == "RereadFailed" || error.code() == "KernelFailure");
}

StepReport writeChecked(const TriMesh& input, const std::string& path, StepOptions& options,
                        RunContext& run) {
  const Format format = formatOf(path);
  checkOptions(options);
  SafeFile file(path);
  Stopwatch watch;
  StepReport report;
  const HalfEdgeMesh mesh = buildHalfEdges(input, run);
  KernelSession kernel;
  try {
    OCC_CATCH_SIGNALS
    const Built built = buildWithinLimits(mesh, options, format, run);
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
      return readStepFile(file.temporary(), kernel, run);
    };
    ShapeCheck check = checkShape(readBack(), run, 0.8, 1.0);
    if (!check.valid && format == Format::Step && !isFlat(built.model)) {
      // Some curved faces need their parameter curves in the file, which the kernel adds.
      writeStepFile(built.brep.shape, file.temporary(), name, options, kernel, run);
      check = checkShape(readBack(), run, 0.8, 1.0);
    }
    compare(check, mesh, options);
    report.facesByKind.assign(built.facesByKind.begin(), built.facesByKind.end());
    report.deviation = built.deviation;
    report.tolerance = options.tolerance;
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

StepSchema parseStepSchema(const std::string& text) {
  if (text == "ap214") return StepSchema::Ap214;
  if (text == "ap242") return StepSchema::Ap242;
  throw Error(Status::InvalidInput, "BadOption", "schema is '" + text + "'; allowed: ap214, ap242");
}

SolidEstimate estimateSolid(const TriMesh& mesh, const StepOptions& options, RunContext& run) {
  const HalfEdgeMesh whole = buildHalfEdges(mesh, run);
  SolidEstimate estimate;
  estimate.triangles = static_cast<std::int64_t>(whole.triangles.size());
  if (options.tolerance > 0) {
    estimate.faces =
        static_cast<std::int64_t>(thinOut(whole, options.tolerance, run).triangles.size());
  } else {
    Partition partition;
    partition.patchOf.assign(whole.triangles.size(), -1);
    if (options.mergeCoplanar) growPlanes(whole, options.planarTolerance, partition, run);
    estimate.faces =
        static_cast<std::int64_t>(partition.patches.size()) +
        std::count(partition.patchOf.begin(), partition.patchOf.end(), std::int32_t{-1});
  }
  estimate.megabytes = megabytesOf(estimate.faces, Format::Step);
  estimate.seconds = kSecondsPerFace * static_cast<double>(estimate.faces) +
                     kSecondsPerTriangle * static_cast<double>(estimate.triangles);
  return estimate;
}

StepReport writeSolid(const TriMesh& mesh, const std::string& path, const StepOptions& options,
                      RunContext& run) {
  StepOptions used = options;
  try {
    return writeChecked(mesh, path, used, run);
  } catch (const Error& error) {
    if (used.tolerance <= 0 || !options.recognise || !isWorthFacets(error)) throw;
    // Never a failed export for the sake of nicer surfaces: once more with simplified facets only.
    used.recognise = false;
    StepReport report = writeChecked(mesh, path, used, run);
    report.note = std::string("no surfaces were recognised, because with them ") + error.what();
    return report;
  }
}

}  // namespace swept
