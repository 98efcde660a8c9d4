// SPDX-License-Identifier: LGPL-2.1-or-later
#include "io/mesh_writers.h"

#include <array>
#include <bit>
#include <charconv>
#include <cstring>
#include <string>

namespace swept {
namespace {

static_assert(std::endian::native == std::endian::little && sizeof(Eigen::Vector3d) == 24);

/// Collects bytes or text and writes them to the stream in large pieces.
class Block {
 public:
  explicit Block(std::ostream& stream) : stream_(stream) {}
  ~Block() { flush(); }
  Block(const Block&) = delete;
  Block& operator=(const Block&) = delete;

  void add(const void* bytes, std::size_t count) {
    text_.append(static_cast<const char*>(bytes), count);
    if (text_.size() > kBytes) flush();
  }
  void add(const char* text) { add(text, std::strlen(text)); }
  /// Writes the shortest text that reads back as exactly this number.
  template <class Number>
  void addNumber(Number number) {
    std::array<char, 40> digits;
    add(digits.data(), static_cast<std::size_t>(
                           std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr -
                           digits.data()));
  }

 private:
  static constexpr std::size_t kBytes = 1 << 16;
  void flush() {
    stream_.write(text_.data(), static_cast<std::streamsize>(text_.size()));
    text_.clear();
  }
  std::ostream& stream_;
  std::string text_;
};

/// Writes a row "HEAD x y z" per vertex and a row "HEAD a b c" per triangle. The first vertex has
/// the number `first`.
void addRows(const TriMesh& mesh, const char* vertexHead, const char* triangleHead,
             std::int32_t first, Block& block) {
  const auto add = [&](const char* head, const auto& row, auto plus) {
    block.add(head);
    for (int k = 0; k < 3; ++k) {
      if (k > 0) block.add(" ");
      block.addNumber(row[k] + plus);
    }
    block.add("\n");
  };
  for (const Eigen::Vector3d& vertex : mesh.vertices) add(vertexHead, vertex, 0.0);
  for (const auto& triangle : mesh.triangles) add(triangleHead, triangle, first);
}

}  // namespace

void writePly(const TriMesh& mesh, std::ostream& stream) {
  stream << "ply\nformat binary_little_endian 1.0\ncomment unit mm\nelement vertex "
         << std::to_string(mesh.vertices.size())
         << "\nproperty double x\nproperty double y\nproperty double z\nelement face "
         << std::to_string(mesh.triangles.size())
         << "\nproperty list uchar int vertex_indices\nend_header\n";
  Block block(stream);
  block.add(mesh.vertices.data(), 24 * mesh.vertices.size());
  for (const auto& triangle : mesh.triangles) {
    block.add("\3");
    block.add(triangle.data(), 12);
  }
}

void writeObj(const TriMesh& mesh, std::ostream& stream) {
  Block block(stream);
  addRows(mesh, "v ", "f ", 1, block);
}

void writeOff(const TriMesh& mesh, std::ostream& stream) {
  Block block(stream);
  block.add("OFF\n");
  block.addNumber(mesh.vertices.size());
  block.add(" ");
  block.addNumber(mesh.triangles.size());
  block.add(" 0\n");
  addRows(mesh, "", "3 ", 0, block);
}

void writeStl(const TriMesh& mesh, std::ostream& stream) {
  Block block(stream);
  std::array<char, 80> head{"triangles in mm"};
  block.add(head.data(), head.size());
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  block.add(&count, sizeof(count));
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3d &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]],
                          &c = mesh.vertices[t[2]];
    const Eigen::Vector3d normal = (b - a).cross(c - a).normalized();
    for (const Eigen::Vector3d& row : {normal, a, b, c}) {
      const Eigen::Vector3f values = row.cast<float>();
      block.add(values.data(), 12);
    }
    block.add("\0\0", 2);
  }
}

}  // namespace swept
