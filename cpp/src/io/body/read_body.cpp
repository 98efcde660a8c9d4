// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>

#include "base/number_text.h"
#include "base/safe_file.h"
#include "swept/body.h"
#include "swept/io.h"
#ifdef HAVE_SWEPT_SOLID
#include "swept/solid.h"
#endif

namespace swept {
namespace {

constexpr std::array kSolidSuffixes{"step", "stp", "brep", "brp"};
constexpr std::array kMeshSuffixes{"ply", "stl", "obj", "off"};

template <std::size_t N>
bool isOneOf(const std::string& suffix, const std::array<const char*, N>& known) {
  return std::find(known.begin(), known.end(), suffix) != known.end();
}

/// Returns true if the file begins like a STEP file (with the number of the standard) or a BREP
/// file (with the name of the kernel or of its shape).
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

#ifdef HAVE_SWEPT_SOLID

double longestSide(const std::vector<ImportedSolid>& solids) {
  Eigen::AlignedBox3d box;
  for (const ImportedSolid& solid : solids) {
    for (const Eigen::Vector3d& v : solid.mesh.vertices) box.extend(v);
  }
  return box.sizes().maxCoeff();
}

/// Returns the tessellation tolerance for a run whose cell is not known yet. Derives it from the
/// size of the body, measured on coarse triangles. However the body is turned, the longest side of
/// the box of its sweep is at least the longest side of the body divided by the square root of 3.
double toleranceFromSize(const std::string& path, const BodyFileOptions& options, RunContext& run) {
  constexpr double kCoarse = 1;  // mm; or half a radian, whichever gives the finer mesh
  const double side = longestSide(readSolids(path, kCoarse, 0.5, run));
  return kTessellationFraction * side / std::sqrt(3.0) / options.resolution;
}

Body readSolidBody(const std::string& path, const BodyFileOptions& options, RunContext& run) {
  if (options.millimetresPerUnit != 1) {
    throw Error(
        Status::InvalidInput, "BadOption",
        "'" + path + "' contains its own unit of length; leave out the option for the unit");
  }
  Body body;
  body.chordError = options.tolerance  ? *options.tolerance
                    : options.cellSize ? kTessellationFraction * *options.cellSize
                                       : toleranceFromSize(path, options, run);
  if (!(body.chordError > 0)) {
    throw Error(Status::InvalidInput, "BadOption",
                "the tolerance for the triangles of '" + path + "' is " +
                    numberText(body.chordError, kTellingDigits) + " mm, but must be above 0");
  }
  if (!(options.angle > 0)) {
    throw Error(Status::InvalidInput, "BadOption",
                "the angle between the triangles of '" + path + "' is " +
                    numberText(options.angle, kTellingDigits) + " rad, but must be above 0");
  }
  const std::vector<ImportedSolid> solids =
      readSolids(path, body.chordError, options.angle, run, &body.shape);
  for (const ImportedSolid& solid : solids) {
    const auto first = static_cast<std::int32_t>(body.mesh.vertices.size());
    body.mesh.vertices.insert(body.mesh.vertices.end(), solid.mesh.vertices.begin(),
                              solid.mesh.vertices.end());
    for (const auto& t : solid.mesh.triangles) {
      body.mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    }
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

std::vector<NamedPart> readSolidParts(const std::string& path, double deflection, RunContext& run) {
  std::vector<NamedPart> parts;
  for (ImportedSolid& solid : readSolids(path, deflection, 0.2, run))
    parts.push_back({solid.name, std::move(solid.mesh), deflection});
  return parts;
}

#else

[[noreturn]] void refuseSolid(const std::string& path) {
  throw Error(Status::InvalidInput, "BadFormat",
              "'" + path +
                  "': this program was built without OpenCASCADE and cannot read solids; give a "
                  "mesh (ply, stl, obj, off)");
}

Body readSolidBody(const std::string& path, const BodyFileOptions&, RunContext&) {
  refuseSolid(path);
}

std::vector<NamedPart> readSolidParts(const std::string& path, double, RunContext&) {
  refuseSolid(path);
}

#endif

}  // namespace

bool isSolidFile(const std::string& path) {
  const std::string suffix = suffixOf(path);
  if (isOneOf(suffix, kSolidSuffixes)) return true;
  return !isOneOf(suffix, kMeshSuffixes) && beginsLikeSolid(path);
}

Body readBody(const std::string& path, const BodyFileOptions& options, RunContext& run) {
  if (isSolidFile(path)) return readSolidBody(path, options, run);
  return {readMesh(path, options.millimetresPerUnit), 0, {}};
}

std::vector<NamedPart> readParts(const std::string& path, const PartFileOptions& options,
                                 RunContext& run) {
  if (isSolidFile(path)) return readSolidParts(path, options.deflection, run);
  std::vector<NamedPart> parts(1);
  parts[0].name = utf8FromPath(pathFromUtf8(path).stem());
  parts[0].mesh = readMesh(path, options.millimetresPerUnit);
  parts[0].chordError = options.chordError;
  return parts;
}

}  // namespace swept
