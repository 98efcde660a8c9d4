// SPDX-License-Identifier: LGPL-2.1-or-later
#include "io/stl_mesh.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <map>
#include <optional>

#include "base/limits.h"
#include "io/input_file.h"
#include "io/text_mesh.h"

namespace swept {
namespace {

constexpr std::uint64_t kHeadBytes = 84, kTriangleBytes = 50;

/// The mesh read so far, to which the readers add one corner after another.
class CornerWelder {
 public:
  explicit CornerWelder(const std::string& path) : path_(path) {}

  /// `where`: of the corner in the file, for messages.
  template <class Where>
  void add(const std::array<float, 3>& p, const Where& where) {
    if (!(std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]))) {
      throw Error(Status::InvalidInput, "NonFiniteVertex",
                  "'" + path_ + "', " + where() +
                      ": a coordinate is not a finite number; "
                      "export the mesh again from its source");
    }
    const auto [place, isNew] = vertexAt_.try_emplace(p, static_cast<std::int32_t>(count_));
    if (isNew && ++count_ > kMaxElements)
      badFile("'" + path_ + "' has more than " + std::to_string(kMaxElements) + " vertices");
    if (isNew) list.vertices.emplace_back(p[0], p[1], p[2]);
    triangle_[given_++ % 3] = place->second;
    if (given_ % 3 != 0) return;
    const auto& [a, b, c] = triangle_;
    if (a == b || b == c || c == a) return;
    list.corners.insert(list.corners.end(), triangle_.begin(), triangle_.end());
    list.faceStart.push_back(list.corners.size());
  }
  std::uint64_t given() const { return given_; }

  PolygonList list;

 private:
  std::string path_;
  std::map<std::array<float, 3>, std::int32_t> vertexAt_;
  std::array<std::int32_t, 3> triangle_{};
  std::uint64_t count_ = 0, given_ = 0;  // vertices, corners
};

/// Returns the number of triangles of a binary file, or nothing for a text file. A text STL need
/// not begin with "solid", and a binary STL may. So the file size decides.
std::optional<std::uint64_t> binaryTriangles(std::istream& stream, std::uint64_t fileBytes,
                                             const std::string& path) {
  std::array<char, kHeadBytes> head{};
  stream.read(head.data(), head.size());
  const auto got = stream.gcount();
  stream.clear();
  const bool saysSolid = got >= 5 && std::memcmp(head.data(), "solid", 5) == 0;
  if (got < std::ssize(head)) {
    if (!saysSolid) badFile("'" + path + "' is too short for an STL file");
    return std::nullopt;
  }
  std::uint32_t count = 0;
  std::memcpy(&count, &head[80], sizeof(count));
  const std::uint64_t needed = kHeadBytes + kTriangleBytes * count;
  if (needed == fileBytes || (needed < fileBytes && !saysSolid)) return count;
  if (saysSolid) return std::nullopt;
  badFile("'" + path + "' declares " + std::to_string(count) + " triangles (" +
          std::to_string(needed) + " bytes), but is " + std::to_string(fileBytes) +
          " bytes long; it is truncated, or is not an STL file");
}

void readBinary(std::istream& stream, std::uint64_t triangles, CornerWelder& mesh) {
  static_assert(std::endian::native == std::endian::little);
  std::array<char, kTriangleBytes> bytes{};
  for (std::uint64_t t = 0; t < triangles && stream.read(bytes.data(), bytes.size()); ++t) {
    std::array<std::array<float, 3>, 4> rows{};  // the normal and the corners
    std::memcpy(rows.data(), bytes.data(), sizeof(rows));
    for (int k = 1; k < 4; ++k)
      mesh.add(rows[k], [&] { return "triangle " + std::to_string(t) + " (counted from 0)"; });
  }
}

void readText(std::istream& stream, const std::string& path, CornerWelder& mesh) {
  const std::string text = readAll(stream);
  TextScanner scan(text, path);
  do {
    const std::string_view key = scan.word();
    if (key != "vertex" && key != "VERTEX") continue;
    std::array<float, 3> p{};
    for (float& x : p) {
      const std::string_view word = scan.word();
      if (!parseNumber(word, x)) scan.expected("a number", word);
    }
    mesh.add(p, [&] { return "line " + std::to_string(scan.line()); });
  } while (scan.nextLine());
  if (mesh.given() % 3 != 0) {
    badFile("'" + path + "' has " + std::to_string(mesh.given()) +
            " vertices, but the number must be a multiple of 3; the file is truncated");
  }
}

}  // namespace

PolygonList readStl(std::istream& stream, std::uint64_t fileBytes, const std::string& path) {
  CornerWelder mesh(path);
  if (const auto triangles = binaryTriangles(stream, fileBytes, path)) {
    readBinary(stream, *triangles, mesh);
  } else {
    readText(stream, path, mesh);
  }
  return std::move(mesh.list);
}

}  // namespace swept
