// Reads and writes mesh files.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>

#include "base/limits.h"
#include "base/number_text.h"
#include "base/safe_file.h"
#include "geometry/mesh_numbers.h"
#include "io/input_file.h"
#include "io/mesh_writers.h"
#include "io/ply_mesh.h"
#include "io/polygon_split.h"
#include "io/single_precision.h"
#include "io/stl_mesh.h"
#include "io/text_mesh.h"
#include "io/three_mf.h"
#include "swept/io.h"

namespace swept {
namespace {

constexpr std::size_t kMaxPolygonCorners = 20000;

bool isMeshSuffix(const std::string& suffix) {
  return suffix == "ply" || suffix == "stl" || suffix == "obj" || suffix == "off";
}

TriMesh toTriangles(PolygonList found, const std::string& path) {
  const auto vertexCount = static_cast<std::int64_t>(found.vertices.size());
  TriMesh mesh;
  mesh.triangles.reserve(found.faces());
  for (std::size_t f = 0; f < found.faces(); ++f) {
    const std::span<const std::int32_t> corners(
        found.corners.data() + found.faceStart[f],
        static_cast<std::size_t>(found.faceStart[f + 1] - found.faceStart[f]));
    for (const std::int32_t corner : corners) {
      if (corner >= 0 && corner < vertexCount) continue;
      badFile("'" + path + "': face " + std::to_string(f) + " refers to vertex " +
              std::to_string(corner) + ", but the file has " +
              counted(vertexCount, "vertex", "vertices") +
              " (faces and vertices are counted from 0); the file is damaged: export it again");
    }
    if (corners.size() > kMaxPolygonCorners) {
      badFile("'" + path + "': face " + std::to_string(f) + " (counted from 0) has " +
              std::to_string(corners.size()) + " corners (limit " +
              std::to_string(kMaxPolygonCorners) + "); triangulate the mesh before export");
    }
    splitPolygon(found.vertices, corners, mesh.triangles);
  }
  mesh.vertices = std::move(found.vertices);
  return mesh;
}

void scaleAndCheck(TriMesh& mesh, double factor) {
  if (!(factor > 0) || !std::isfinite(factor)) {
    throw Error(Status::InvalidInput, "BadOption",
                "the number of millimetres per unit is " + numberText(factor, kTellingDigits) +
                    ", but must be a finite number above 0, such as 1 for mm or 1000 for m");
  }
  if (factor == 1.0) return;
  for (Eigen::Vector3d& vertex : mesh.vertices) vertex *= factor;
}

PolygonList readPly(InputFile& file, const std::string& path) {
  const PlyHeader header = readPlyHeader(*file.stream, file.bytes, path);
  return readPlyMesh(*file.stream, header, file.bytes, path);
}

PolygonList readPolygons(InputFile& file, const std::string& suffix, const std::string& path) {
  if (suffix == "ply") return readPly(file, path);
  if (suffix == "obj") return readObj(*file.stream, path);
  if (suffix == "off") return readOff(*file.stream, path);
  return readStl(*file.stream, file.bytes, path);
}

}  // namespace

TriMesh readMesh(const std::string& path, double millimetresPerUnit, const std::string& format) {
  const std::string suffix = format.empty() ? suffixOf(path) : format;
  if (!isMeshSuffix(suffix)) {
    badFile("'" + path + "': unknown mesh format '" + suffix + "'; use ply, stl, obj or off");
  }
  InputFile file = openInput(path);
  if (file.bytes == 0) badFile("'" + path + "' is empty (0 bytes)");
  TriMesh mesh = toTriangles(readPolygons(file, suffix, path), path);
  scaleAndCheck(mesh, millimetresPerUnit);
  return mesh;
}

TriMesh meshAsWritten(const TriMesh& mesh, const std::string& suffix) {
  return suffix == "stl" ? inSinglePrecision(mesh) : mesh;
}

void writeMesh(const TriMesh& mesh, const std::string& path) {
  const std::string suffix = suffixOf(path);
  if (!isMeshSuffix(suffix) && suffix != "3mf") {
    throw Error(
        Status::ExportFailed, "BadFormat",
        "'" + path + "': unknown mesh format '" + suffix + "'; use ply, stl, obj, off or 3mf");
  }
  if (mesh.vertices.size() > kMaxElements || mesh.triangles.size() > kMaxElements) {
    throw Error(Status::ExportFailed, "TooManyFaces",
                "'" + path + "': a mesh file can hold at most " + std::to_string(kMaxElements) +
                    " vertices or triangles, but the mesh has " +
                    std::to_string(mesh.triangles.size()) + " triangles");
  }
  if (const auto bad = findBadIndex(mesh))
    throw Error(Status::InvalidInput, "BadIndex",
                badIndexText(*bad, mesh) + "; correct the triangles of the mesh");
  SafeFile file(path);
  if (suffix == "3mf") {
    file.close();
    writeThreeMf(mesh, file.temporary());
  } else if (suffix == "ply") {
    writePly(mesh, file.stream());
  } else if (suffix == "obj") {
    writeObj(mesh, file.stream());
  } else if (suffix == "off") {
    writeOff(mesh, file.stream());
  } else {
    writeStl(meshAsWritten(mesh, suffix), file.stream());
  }
  file.commit();
}

}  // namespace swept
