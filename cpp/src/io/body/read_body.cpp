// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <functional>

#include "base/number_text.h"
#include "base/safe_file.h"
#include "swept/body.h"
#include "swept/io.h"
#include "swept/solid.h"

namespace swept {
namespace {

constexpr std::array kSolidSuffixes{"step", "stp", "brep", "brp"};
constexpr std::array kMeshSuffixes{"ply", "stl", "obj", "off"};

template <std::size_t N>
bool isOneOf(const std::string& suffix, const std::array<const char*, N>& known) {
  return std::find(known.begin(), known.end(), suffix) != known.end();
}

/// Returns true if the file begins like a STEP file ("ISO-10303-21") or like a BREP file of
/// OpenCASCADE.
bool beginsLikeSolid(const std::string& path) {
  std::ifstream file(pathFromUtf8(path), std::ios::binary);
  std::string head(256, '\0');
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
  const std::size_t first = head.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) return false;
  return head.compare(first, 12, "ISO-10303-21") == 0 ||
         head.find("DBRep_DrawableShape") != std::string::npos ||
         head.find("CASCADE Topology V") != std::string::npos;
}

// A function that reads the solids of a file with a linear (mm) and an angular deflection (rad).
// Either the geometry kernel reads them, or a SolidReader of the caller. `shape` may be null.
using Shape = std::shared_ptr<const BodyShape>;
using Read = std::function<std::vector<ImportedSolid>(double linear, double angular, Shape* shape)>;

Read byKernel(const std::string& path, RunContext& run) {
  return [&](double linear, double angular, Shape* shape) {
    return readSolids(path, linear, angular, run, shape);
  };
}

Read byCaller(const std::string& path, SolidReader& reader, RunContext& run) {
  return [&](double linear, double angular, Shape* /*shape*/) {
    run.checkpoint(Phase::Input);
    std::vector<ImportedSolid> solids = reader.read(path, linear, angular);
    run.checkpoint(Phase::Input);
    const auto isEmpty = [](const ImportedSolid& solid) { return solid.mesh.triangles.empty(); };
    solids.erase(std::remove_if(solids.begin(), solids.end(), isEmpty), solids.end());
    if (solids.empty())
      throw Error(
          Status::InvalidInput, "NoSurface",
          "'" + path + "' contains no face that can be turned into triangles; export a solid");
    return solids;
  };
}

double longestSide(const std::vector<ImportedSolid>& solids) {
  Eigen::AlignedBox3d box;
  for (const ImportedSolid& solid : solids) {
    for (const Eigen::Vector3d& v : solid.mesh.vertices) box.extend(v);
  }
  return box.sizes().maxCoeff();
}

/// Returns the tessellation tolerance (mm) for a run whose cell size is not known yet. Derives it
/// from the size of the body, measured on coarse triangles. However the body is turned, the longest
/// side of the box of its sweep is at least the longest side of the body divided by the square root
/// of 3.
double toleranceFromSize(const Read& read, int resolution) {
  constexpr double kCoarse = 1;  // mm, linear deflection; the angular deflection is half a radian
  const double side = longestSide(read(kCoarse, 0.5, nullptr));
  return kTessellationFraction * side / std::sqrt(3.0) / resolution;
}

Body readSolidBody(const std::string& path, const BodyFileOptions& options, const Read& read) {
  if (options.millimetresPerUnit != 1) {
    throw Error(
        Status::InvalidInput, "BadOption",
        "'" + path + "' contains its own unit of length; leave out the option for the unit");
  }
  Body body;
  body.chordError = options.tolerance  ? *options.tolerance
                    : options.cellSize ? kTessellationFraction * *options.cellSize
                                       : toleranceFromSize(read, options.resolution);
  if (!(body.chordError > 0)) {
    throw Error(Status::InvalidInput, "BadOption",
                "the tolerance for meshing '" + path + "' is set to " +
                    numberText(body.chordError, kTellingDigits) + " mm, but must be above 0");
  }
  if (!(options.angle > 0)) {
    throw Error(Status::InvalidInput, "BadOption",
                "the largest angle between adjacent triangles for meshing '" + path +
                    "' is set to " + numberText(options.angle, kTellingDigits) +
                    " rad, but must be above 0");
  }
  const std::vector<ImportedSolid> solids = read(body.chordError, options.angle, &body.shape);
  const bool facesAreKnown =
      std::none_of(solids.begin(), solids.end(),
                   [](const ImportedSolid& solid) { return solid.mesh.faceOf.empty(); });
  for (const ImportedSolid& solid : solids) {
    const auto first = static_cast<std::int32_t>(body.mesh.vertices.size());
    body.mesh.vertices.insert(body.mesh.vertices.end(), solid.mesh.vertices.begin(),
                              solid.mesh.vertices.end());
    for (const auto& t : solid.mesh.triangles) {
      body.mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    }
    if (facesAreKnown)
      body.mesh.faceOf.insert(body.mesh.faceOf.end(), solid.mesh.faceOf.begin(),
                              solid.mesh.faceOf.end());
  }
  const auto count = static_cast<std::int64_t>(solids.size());
  body.findings.push_back({"Tessellated",
                           count,
                           {},
                           counted(count, "solid was", "solids were") + " read as " +
                               std::to_string(body.mesh.triangles.size()) +
                               " triangles, which deviate from the surface by at most " +
                               numberText(body.chordError, 3) + " mm"});
  return body;
}

std::vector<NamedPart> readSolidParts(double deflection, const Read& read) {
  std::vector<NamedPart> parts;
  for (ImportedSolid& solid : read(deflection, 0.2, nullptr))
    parts.push_back({solid.name, std::move(solid.mesh), deflection});
  return parts;
}

Body readMeshBody(const std::string& path, const BodyFileOptions& options) {
  return {readMesh(path, options.millimetresPerUnit), 0, {}};
}

std::vector<NamedPart> readMeshPart(const std::string& path, const PartFileOptions& options) {
  std::vector<NamedPart> parts(1);
  parts[0].name = utf8FromPath(pathFromUtf8(path).stem());
  parts[0].mesh = readMesh(path, options.millimetresPerUnit);
  parts[0].chordError = options.chordError;
  return parts;
}

}  // namespace

bool isSolidFile(const std::string& path) {
  const std::string suffix = suffixOf(path);
  if (isOneOf(suffix, kSolidSuffixes)) return true;
  return !isOneOf(suffix, kMeshSuffixes) && beginsLikeSolid(path);
}

Body readBody(const std::string& path, const BodyFileOptions& options, RunContext& run) {
  if (!isSolidFile(path)) return readMeshBody(path, options);
  return readSolidBody(path, options, byKernel(path, run));
}

Body readBody(const std::string& path, const BodyFileOptions& options, SolidReader& reader,
              RunContext& run) {
  if (!isSolidFile(path)) return readMeshBody(path, options);
  return readSolidBody(path, options, byCaller(path, reader, run));
}

std::vector<NamedPart> readParts(const std::string& path, const PartFileOptions& options,
                                 RunContext& run) {
  if (!isSolidFile(path)) return readMeshPart(path, options);
  return readSolidParts(options.deflection, byKernel(path, run));
}

std::vector<NamedPart> readParts(const std::string& path, const PartFileOptions& options,
                                 SolidReader& reader, RunContext& run) {
  if (!isSolidFile(path)) return readMeshPart(path, options);
  return readSolidParts(options.deflection, byCaller(path, reader, run));
}

}  // namespace swept
