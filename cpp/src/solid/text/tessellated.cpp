// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/text/tessellated.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <map>

#include "base/safe_file.h"
#include "base/timer.h"
#include "solid/carrier/curve.h"
#include "solid/mesh/half_edge.h"
#include "solid/text/step_lines.h"

namespace swept::step {
namespace {

constexpr double kBytesPerTriangle = 45;
// Volumes count as equal if they differ by less than this fraction of area^1.5.
constexpr double kSameVolume = 1e-9;

class TessellatedWriter {
 public:
  TessellatedWriter(const HalfEdgeMesh& mesh, std::ostream& out, const SolidOptions& options,
                    RunContext& run)
      : mesh_(mesh), options_(options), lines_(out, run), sections_(lines_, options) {}

  void write(const std::string& fileName) {
    sections_.header(fileName);
    std::vector<std::vector<Id>> faces(mesh_.shellOwner.size());
    const std::vector<std::vector<std::int32_t>> shells = trianglesOfShells();
    for (std::size_t s = 0; s < shells.size(); ++s)
      faces[mesh_.shellOwner[s]].push_back(face(shells[s]));
    std::vector<Id> solids;
    for (const std::vector<Id>& items : faces) {
      if (items.empty()) continue;
      solids.push_back(lines_.begin("TESSELLATED_SOLID"));
      lines_.raw(stepString(options_.productName)).raw(",").ids(items).raw(",$").end();
    }
    const Id context = sections_.context(kKernelTolerance);
    sections_.product("TESSELLATED_SHAPE_REPRESENTATION", solids, solids, context);
    sections_.end();
  }

 private:
  std::vector<std::vector<std::int32_t>> trianglesOfShells() const {
    std::vector<std::vector<std::int32_t>> shells(mesh_.shellOwner.size());
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
      shells[mesh_.shellOf[t]].push_back(static_cast<std::int32_t>(t));
    return shells;
  }

  // Writes the points of one shell, numbered from 1, and its triangles. Returns the id of the face.
  Id face(const std::vector<std::int32_t>& triangles) {
    std::vector<std::int32_t> points;
    numberOf_.resize(mesh_.points.size(), 0);
    for (const std::int32_t t : triangles) {
      for (const std::int32_t v : mesh_.triangles[t]) {
        if (numberOf_[v] > 0) continue;
        points.push_back(v);
        numberOf_[v] = static_cast<std::int32_t>(points.size());
      }
    }
    const Id list = lines_.begin("COORDINATES_LIST");
    const auto count = static_cast<Id>(points.size());
    lines_.raw("'',").integer(count);
    for (std::size_t i = 0; i < points.size(); ++i) {
      lines_.raw(i == 0 ? ",(" : ",").triple(mesh_.points[points[i]], true);
      lines_.flushIfLong();
    }
    lines_.raw(")").end();
    const Id id = lines_.begin("TRIANGULATED_FACE");
    // The empty attributes are the normals, the surface, and the list that would select some of the
    // points.
    lines_.raw("'',").id(list).raw(",").integer(count);
    lines_.raw(",(),$,()");
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      const auto& tri = mesh_.triangles[triangles[i]];
      lines_.raw(i == 0 ? ",((" : ",(").integer(numberOf_[tri[0]]);
      lines_.raw(",").integer(numberOf_[tri[1]]);
      lines_.raw(",").integer(numberOf_[tri[2]]);
      lines_.raw(")").flushIfLong();
    }
    lines_.raw(")").end();
    return id;
  }

  const HalfEdgeMesh& mesh_;
  const SolidOptions& options_;
  Lines lines_;
  FileSections sections_;
  // For each vertex, its number in the point list of its shell, from 1.
  std::vector<std::int32_t> numberOf_;
};

// Reads the points and triangles of a file, statement by statement.
class Reader {
 public:
  Reader(std::istream& text, RunContext& run) : in_(*text.rdbuf()), run_(run) {}

  TriMesh read() {
    while (seekEntity()) {
      const std::string keyword = word();
      if (keyword == "COORDINATES_LIST") readPoints();
      if (keyword == "TRIANGULATED_FACE") readFace();
    }
    return std::move(mesh_);
  }

 private:
  static constexpr int kEnd = std::char_traits<char>::eof();
  struct List {
    std::int32_t first = 0, count = 0;
  };

  [[noreturn]] static void fail(const std::string& what) {
    throw Error(
        Status::ExportFailed, "RereadFailed",
        "the tessellated solid was not saved, because its file cannot be read back: " + what +
            ". If a file with this name existed, it is unchanged. Export a mesh file "
            "instead");
  }

  // Moves to just after `#n=` of the next entity. Returns false at the end of the file.
  bool seekEntity() {
    for (int c = in_.sbumpc(); c != kEnd; c = in_.sbumpc()) {
      if (c == '\'') skipString();
      if (c == ';') atStart_ = true;
      if (c != '#' || !atStart_) continue;
      atStart_ = false;
      id_ = integer();
      if (in_.sbumpc() != '=') fail("an entity has no '='");
      return true;
    }
    return false;
  }
  void skipString() {
    for (int c = in_.sbumpc(); c != '\'' && c != kEnd;) c = in_.sbumpc();
  }
  std::string word() {
    std::string result;
    for (int c = in_.sgetc(); c == '_' || (c >= 'A' && c <= 'Z'); c = in_.snextc())
      result += static_cast<char>(c);
    return result;
  }
  void expect(const char* marks) {
    for (; *marks != 0; ++marks) {
      if (in_.sbumpc() != *marks) fail(std::string("'") + *marks + "' is missing");
    }
  }
  std::int64_t integer() {
    std::int64_t value = 0;
    bool any = false;
    for (int c = in_.sgetc(); c >= '0' && c <= '9' && value < (std::int64_t{1} << 40U);
         c = in_.snextc()) {
      value = 10 * value + (c - '0');
      any = true;
    }
    if (!any) fail("a number is missing");
    return value;
  }
  double real() {
    char text[64];
    char* end = text;
    for (int c = in_.sgetc(); end < text + 63 && c != ',' && c != ')' && c != kEnd;
         c = in_.snextc())
      *end++ = static_cast<char>(c);
    double value = 0;
    const auto [stop, error] = std::from_chars(text, end, value);
    // A STEP real may end with its decimal point.
    if (error != std::errc() || (stop != end && !(stop + 1 == end && *stop == '.')))
      fail("a coordinate is not a number");
    return value;
  }
  // Returns true after ',' (the list continues) and false after ')'.
  bool more() {
    const int c = in_.sbumpc();
    if (c != ',' && c != ')') fail("a list does not end");
    return c == ',';
  }

  void readPoints() {
    expect("('',");
    List list{static_cast<std::int32_t>(mesh_.vertices.size()),
              static_cast<std::int32_t>(integer())};
    expect(",(");
    do {
      expect("(");
      Eigen::Vector3d p;
      for (int k = 0; k < 3; ++k) {
        p[k] = real();
        expect(k < 2 ? "," : ")");
      }
      mesh_.vertices.push_back(p);
      checkpoint();
    } while (more());
    if (static_cast<std::int64_t>(mesh_.vertices.size()) != list.first + list.count)
      fail("the number of points in a list differs from the number that it declares");
    lists_[id_] = list;
  }

  void readFace() {
    expect("('',#");
    const auto found = lists_.find(integer());
    if (found == lists_.end()) fail("a face refers to points that do not exist");
    const List list = found->second;
    expect(",");
    integer();
    expect(",(),$,(),(");
    do {
      expect("(");
      std::array<std::int32_t, 3> triangle{};
      for (int k = 0; k < 3; ++k) {
        const std::int64_t number = integer();
        if (number < 1 || number > list.count)
          fail("a triangle refers to a point that does not exist");
        triangle[k] = static_cast<std::int32_t>(list.first + number - 1);
        expect(k < 2 ? "," : ")");
      }
      mesh_.triangles.push_back(triangle);
      checkpoint();
    } while (more());
  }

  void checkpoint() {
    if ((++read_ & 0xFFFFU) == 0) run_.checkpoint(Phase::Export);
  }

  std::streambuf& in_;
  RunContext& run_;
  TriMesh mesh_;
  std::map<std::int64_t, List> lists_;
  std::int64_t id_ = 0;
  std::uint64_t read_ = 0;
  bool atStart_ = false;
};

void compare(const HalfEdgeMesh& read, const HalfEdgeMesh& written) {
  const double allowed =
      kSameVolume * written.area * std::sqrt(written.area) + 1e-12 * std::abs(written.volume);
  std::string what;
  if (read.triangles.size() != written.triangles.size() ||
      read.points.size() != written.points.size()) {
    what = std::to_string(read.triangles.size()) + " triangles instead of " +
           std::to_string(written.triangles.size());
  } else if (read.shellOwner.size() != written.shellOwner.size()) {
    what = std::to_string(read.shellOwner.size()) + " shells instead of " +
           std::to_string(written.shellOwner.size());
  } else if (!(std::abs(read.volume - written.volume) <= allowed)) {
    what = "a different volume";
  }
  if (what.empty()) return;
  throw Error(
      Status::ExportFailed, "RereadDiffers",
      "the solid was not saved, because its file contained a different solid when it was "
      "read back: " +
          what + ". If a file with this name existed, it is unchanged. Export a mesh file instead");
}

void checkOptions(const HalfEdgeMesh& mesh, const SolidOptions& options) {
  if (options.tolerance > 0) {
    throw Error(Status::ExportFailed, "BadOption",
                "a tessellated solid consists of the triangles of the mesh, so it cannot have a "
                "tolerance; simplify the envelope instead");
  }
  const double megabytes = tessellatedMegabytes(static_cast<std::int64_t>(mesh.triangles.size()));
  if (options.maxMegabytes && megabytes > *options.maxMegabytes) {
    throw Error(
        Status::ExportFailed, "TooManyFaces",
        "the tessellated solid of " + std::to_string(mesh.triangles.size()) +
            " triangles would need a file of about " + std::to_string(std::lround(megabytes)) +
            " MB, but the limit is " + std::to_string(std::lround(*options.maxMegabytes)) +
            " MB. Simplify the envelope, raise the limit of the file size, or export a mesh "
            "file");
  }
}

}  // namespace

double tessellatedMegabytes(std::int64_t triangles) {
  return 1e-6 * kBytesPerTriangle * static_cast<double>(triangles);
}

TriMesh readTessellated(std::istream& text, RunContext& run) { return Reader(text, run).read(); }

WrittenSolid writeTessellated(const TriMesh& input, const std::string& path,
                              const SolidOptions& options, RunContext& run) {
  SafeFile file(path);
  Timer timer;
  WrittenSolid report;
  const HalfEdgeMesh mesh = buildHalfEdges(input, run);
  checkOptions(mesh, options);
  report.secondsBuild = timer.lap();
  TessellatedWriter(mesh, file.stream(), options, run)
      .write(utf8FromPath(pathFromUtf8(file.target()).filename()));
  file.close();
  report.secondsWrite = timer.lap();
  std::ifstream text(pathFromUtf8(file.temporary()), std::ios::binary);
  const HalfEdgeMesh read = buildHalfEdges(readTessellated(text, run), run);
  compare(read, mesh);
  report.faces = static_cast<std::int64_t>(read.triangles.size());
  report.edges = 3 * report.faces / 2;
  report.solids = countOuterShells(read.shellOwner);
  report.facesByKind = {{"triangle", report.faces}};
  report.valid = true;
  report.volume = read.volume;
  report.meshVolume = mesh.volume;
  report.secondsReread = timer.lap();
  run.checkpoint(Phase::Export, 1, 1);
  report.fileBytes = file.commit();
  return report;
}

}  // namespace swept::step
