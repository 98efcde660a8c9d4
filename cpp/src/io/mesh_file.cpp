// Reads and writes mesh files. OpenMesh's reader parses STL, but not into OpenMesh's mesh class
// (openmesh_bridge.h gives the reason). The project's own code reads and writes all other formats.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <OpenMesh/Core/IO/reader/STLReader.hh>
#include <OpenMesh/Core/System/omstream.hh>
#include <array>
#include <cmath>
#include <cstring>
#include <iostream>
#include <mutex>
#include <sstream>

#include "base/limits.h"
#include "base/number_text.h"
#include "base/safe_file.h"
#include "geometry/mesh_numbers.h"
#include "io/input_file.h"
#include "io/mesh_writers.h"
#include "io/openmesh_bridge.h"
#include "io/ply_mesh.h"
#include "io/polygon_split.h"
#include "io/single_precision.h"
#include "io/text_mesh.h"
#include "io/three_mf.h"
#include "swept/io.h"

namespace swept {
namespace {

constexpr std::size_t kMaxPolygonCorners = 20000;

// OpenMesh's readers keep state between calls, so only one call may run at a time. They also print
// errors; this class catches the printed text for the error message.
class OpenMeshCall {
 public:
  // Exchanges the stream buffers, because OpenMesh's connect() and disconnect() leak memory with
  // every call.
  OpenMeshCall()
      : lock_(mutex()), errors_(omerr().rdbuf(text_.rdbuf())), log_(omlog().rdbuf(&silence_)) {}
  ~OpenMeshCall() {
    omerr().rdbuf(errors_);
    omlog().rdbuf(log_);
  }
  OpenMeshCall(const OpenMeshCall&) = delete;
  OpenMeshCall& operator=(const OpenMeshCall&) = delete;

  /// Returns the text that OpenMesh printed, on one line.
  std::string printed() const {
    std::string text = text_.str();
    for (char& c : text) {
      if (c == '\n' || c == '\r') c = ' ';
    }
    while (!text.empty() && text.back() == ' ') text.pop_back();
    return text.empty() ? std::string("no reason given") : text.substr(0, 300);
  }

 private:
  static std::mutex& mutex() {
    static std::mutex instance;
    return instance;
  }
  std::lock_guard<std::mutex> lock_;
  std::ostringstream text_;
  std::stringbuf silence_;
  std::streambuf* errors_;
  std::streambuf* log_;
};

bool isMeshSuffix(const std::string& suffix) {
  return suffix == "ply" || suffix == "stl" || suffix == "obj" || suffix == "off";
}

// A text STL need not begin with "solid", and a binary STL may. So the file size decides.
bool isBinaryStl(std::istream& stream, std::uint64_t fileBytes, const std::string& path) {
  std::array<char, 84> head{};
  stream.read(head.data(), head.size());
  const auto got = stream.gcount();
  stream.clear();
  stream.seekg(0);
  const bool saysSolid = got >= 5 && std::memcmp(head.data(), "solid", 5) == 0;
  if (got < 84) {
    if (!saysSolid) badFile("'" + path + "' is too short for an STL file");
    return false;
  }
  const auto byte = [&](int i) {
    return static_cast<std::uint64_t>(static_cast<unsigned char>(head[i]));
  };
  const std::uint64_t count = byte(80) | byte(81) << 8 | byte(82) << 16 | byte(83) << 24;
  const std::uint64_t needed = 84 + 50 * count;
  if (needed == fileBytes || (needed < fileBytes && !saysSolid)) return true;
  if (saysSolid) return false;
  badFile("'" + path + "' declares " + std::to_string(count) + " triangles (" +
          std::to_string(needed) + " bytes), but is " + std::to_string(fileBytes) +
          " bytes long; it is truncated, or is not an STL file");
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

PolygonList readStl(InputFile& file, const std::string& path) {
  OpenMesh::IO::Options options;
  if (isBinaryStl(*file.stream, file.bytes, path)) {
    options += OpenMesh::IO::Options::Binary;
    checkBinaryStl(*file.stream, path);
  } else {
    checkTextStl(*file.stream, path);
  }
  file.stream->clear();
  file.stream->seekg(0);
  // An element takes at least one byte.
  const std::uint64_t limit = std::min(file.bytes, kMaxElements);
  ListImporter found(path, file.bytes, limit, 4 * limit);
  OpenMeshCall call;
  // Calls the reader directly: OpenMesh's IO manager has no readers if OpenMesh is linked
  // statically.
  if (!OpenMesh::IO::STLReader().read(*file.stream, found, options)) {
    badFile("'" + path + "' cannot be read: " + call.printed());
  }
  return std::move(found.list);
}

PolygonList readPolygons(InputFile& file, const std::string& suffix, const std::string& path) {
  if (suffix == "ply") return readPly(file, path);
  if (suffix == "obj") return readObj(*file.stream, path);
  if (suffix == "off") return readOff(*file.stream, path);
  return readStl(file, path);
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
