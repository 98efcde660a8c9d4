// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/solid_build.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/limits.h"
#include "base/number_text.h"
#include "base/safe_file.h"
#include "simplify/thin.h"
#include "solid/body_solid.h"
#include "solid/mesh/decimate.h"
#include "solid/text/step_text.h"

namespace swept {
namespace step {
namespace {

[[noreturn]] void badOption(const std::string& text) {
  throw Error(Status::ExportFailed, "BadOption", text);
}

void requireLength(const char* name, double value) {
  if (value >= 0 && value <= kMaxLength) return;
  badOption(std::string(name) + " is " + numberText(value, kTellingDigits) +
            " mm; allowed: 0 to 1e9 mm");
}

// The kernel, and so most programs that read the file, fail on longer names.
constexpr std::size_t kLongestName = 1000;

void requireName(const char* name, const std::string& text) {
  if (text.size() <= kLongestName) return;
  badOption(std::string(name) + " has " + std::to_string(text.size()) + " bytes; allowed: up to " +
            std::to_string(kLongestName));
}

void requireOrigin(const SolidOrigin& origin) {
  if (origin.shape == nullptr)
    badOption("the body has no faces; give a body that was read from a STEP or BREP file");
}

// Rough figures for estimates and messages, measured on triangulated bodies.
constexpr double kStepBytesPerFace = 750, kBrepBytesPerFace = 700, kBytesByCorners = 340;
constexpr double kSecondsPerFace = 3e-4;

bool isWithinLimits(std::int64_t faces, const HalfEdgeMesh& mesh, const SolidOptions& options,
                    SolidFormat format) {
  return faces <= options.maxFaces &&
         (!options.maxMegabytes ||
          megabytesOf(faces, mesh, options, format) <= *options.maxMegabytes);
}

[[noreturn]] void refuseTooMany(std::int64_t faces, const HalfEdgeMesh& mesh,
                                const SolidOptions& options, SolidFormat format) {
  const auto seconds =
      static_cast<std::int64_t>(std::ceil(kSecondsPerFace * static_cast<double>(faces)));
  std::string text =
      textOf(3, "with a tolerance of ", options.tolerance, " mm, the solid would have ", faces,
             " faces (about ", fixedText(megabytesOf(faces, mesh, options, format), 1), " MB, ",
             seconds, " s to make), but the limit is ", options.maxFaces, " faces");
  if (options.maxMegabytes) text += textOf(3, " and ", *options.maxMegabytes, " MB");
  text += options.exact ? "; an exact solid must not deviate from the mesh, so use larger cells"
                        : "; allow a larger tolerance";
  throw Error(Status::ExportFailed, "TooManyFaces",
              text +
                  ", raise the limit, or export a mesh file (PLY, STL, OBJ, OFF or 3MF), which has "
                  "no such limit");
}

constexpr std::size_t kDense = 150000;  // triangles; a smaller mesh is not thinned first

double diagonalOf(const HalfEdgeMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : mesh.points) box.extend(p);
  return box.diagonal().norm();
}

// Builds with options.tolerance. If it is 0, tries 0 and then a series of tolerances, until the
// solid is within the limits. `options` receives the tolerance.
Built buildUpright(const HalfEdgeMesh& mesh, SolidOptions& options, SolidFormat format,
                   Judge& judge, RunContext& run) {
  const auto fits = [&](std::int64_t count) {
    return isWithinLimits(count, mesh, options, format);
  };
  // First and largest tolerance of the series, as fractions of the diagonal of the bounding box.
  constexpr double kFirst = 1.0 / 4000, kMax = 1.0 / 100;
  const bool given = options.tolerance > 0;
  std::int64_t faces = 0;
  if (!given) {
    if (auto built = makeShape(mesh, mesh, options, fits, judge, faces, run))
      return std::move(*built);
    if (options.exact) refuseTooMany(faces, mesh, options, format);
  }
  const double diagonal = diagonalOf(mesh);
  HalfEdgeMesh thin;
  const HalfEdgeMesh* dense = &mesh;
  if (!given) options.tolerance = kFirst * diagonal;
  // Once only: faces that do not form a solid do not do so with another tolerance.
  const bool hasBody = options.origin != nullptr && options.recognise;
  if (hasBody) {
    if (auto built = makeFromBody(mesh, options, fits, judge, run)) return std::move(*built);
  }
  for (;; options.tolerance *= 2) {
    if (dense->triangles.size() > kDense) {
      // Continues with the mesh of the previous round, which was thinned with half the limit.
      thin = thinned(*dense, kThinFraction * options.tolerance, run);
      dense = &thin;
    }
    auto built = makeShape(mesh, *dense, options, fits, judge, faces, run);
    const bool isLast = given || 2 * options.tolerance > kMax * diagonal;
    if (!built && !isLast) continue;
    if (hasBody) {
      // Of the two solids with facets, the one with fewer faces is better.
      const std::int64_t most = built ? built->faceCount() - 1 : options.maxFaces;
      auto filled = fillFromBody(mesh, options, most, judge, run);
      if (filled && fits(filled->faceCount())) return std::move(*filled);
    }
    if (built) return std::move(*built);
    refuseTooMany(faces, mesh, options, format);
  }
}

}  // namespace

void checkOptions(const SolidOptions& options) {
  requireLength("the planar tolerance", options.planarTolerance);
  requireLength("the solid's tolerance", options.tolerance);
  requireName("the product's name", options.productName);
  requireName("the author", options.author);
  requireName("the organization", options.organization);
  for (const double part : options.colour) {
    if (!(part >= 0 && part <= 1))
      badOption("a component of the colour is " + numberText(part, kTellingDigits) +
                "; allowed: 0 to 1");
  }
  if (options.exact && options.tolerance > 0) {
    badOption("an exact solid cannot have a tolerance; set the tolerance to 0 mm");
  }
  if (options.maxFaces < 4)
    badOption("the limit of faces is " + std::to_string(options.maxFaces) + "; allowed: 4 or more");
  if (options.maxMegabytes && !(*options.maxMegabytes > 0))
    badOption("the limit of the file size is " + numberText(*options.maxMegabytes, kTellingDigits) +
              " MB; allowed: more than 0, or not given (no limit)");
}

double megabytesOf(std::int64_t faces, const HalfEdgeMesh& mesh, const SolidOptions& options,
                   SolidFormat format) {
  // If there are many plane faces and no cavities, the file contains only the corners of the faces.
  const bool corners = faces >= kManyFaces && (options.tolerance <= 0 || !options.recognise) &&
                       countOuterShells(mesh.shellOwner) == std::ssize(mesh.shellOwner);
  const double bytes = format == SolidFormat::Brep ? kBrepBytesPerFace
                       : corners                   ? kBytesByCorners
                                                   : kStepBytesPerFace;
  return 1e-6 * static_cast<double>(faces) * bytes;
}

HalfEdgeMesh thinned(const HalfEdgeMesh& mesh, double limit, RunContext& run) {
  return buildHalfEdges(
      thinOut({mesh.points, mesh.triangles}, limit, ThinFor::Surfaces, Phase::Export, run).mesh,
      run);
}

Built buildWithinLimits(const HalfEdgeMesh& mesh, SolidOptions& options, SolidFormat format,
                        Judge& judge, RunContext& run) {
  if (options.origin != nullptr) requireOrigin(*options.origin);
  return uprightWithin(options.tolerance,
                       [&] { return buildUpright(mesh, options, format, judge, run); });
}

void writeBuilt(const Built& built, Judge& judge, std::ostream& out, const std::string& name,
                const SolidOptions& options, SolidFormat format, RunContext& run) {
  if (built.model.faces.empty()) {
    judge.writeAssembled(out, name, options, format, run);
  } else if (format == SolidFormat::Brep) {
    judge.writeBrep(out, run);
  } else {
    writeStepText(built.model, out, name, options, run);
  }
}

bool isWorthFacets(const Error& error) {
  return error.status() == Status::ExportFailed &&
         (error.code() == "InvalidFaces" || error.code() == "RereadDiffers" ||
          error.code() == "RereadFailed" || error.code() == "KernelFailure" ||
          error.code() == "SolidInaccurate");
}

void refuseMemory(std::size_t triangles) {
  throw Error(Status::OutOfMemory, "OutOfMemory",
              "there is not enough memory to make a solid of " + std::to_string(triangles) +
                  " triangles; simplify the envelope or export a mesh file");
}

}  // namespace step

SolidFormat solidFormatOf(const std::string& path) {
  const std::string suffix = suffixOf(path);
  if (suffix == "step" || suffix == "stp") return SolidFormat::Step;
  if (suffix == "brep" || suffix == "brp") return SolidFormat::Brep;
  throw Error(
      Status::ExportFailed, "BadSuffix",
      "'" + path +
          "' does not end in .step, .stp, .brep or .brp, so the format is unknown; use one of "
          "these endings");
}

}  // namespace swept
