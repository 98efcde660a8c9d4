// SPDX-License-Identifier: LGPL-2.1-or-later
#include "io/freecad_mesh.h"

#include <array>
#include <cstdint>
#include <limits>

#include "geometry/half_edges.h"

namespace swept {
namespace {

template <class T>
void append(std::string& to, const T* values, std::size_t count) {
  to.append(reinterpret_cast<const char*>(values), count * sizeof(T));
}

}  // namespace

std::string freecadMesh(const TriMesh& mesh) {
  const auto points = static_cast<std::uint32_t>(mesh.vertices.size());
  const auto facets = static_cast<std::uint32_t>(mesh.triangles.size());
  const std::array<std::uint32_t, 2> head = {0xA0B0C0D0, 0x010000}, counts = {points, facets};
  const RawArray<std::uint32_t> across = findAdjacency(mesh).across;
  std::string bytes;
  bytes.reserve(296 + 12 * mesh.vertices.size() + 24 * mesh.triangles.size());
  append(bytes, head.data(), head.size());
  bytes.append(256, ' ');
  append(bytes, counts.data(), counts.size());
  Eigen::Vector3f low = Eigen::Vector3f::Constant(std::numeric_limits<float>::max()), high = -low;
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    const Eigen::Vector3f at = vertex.cast<float>();
    low = low.cwiseMin(at);
    high = high.cwiseMax(at);
    append(bytes, at.data(), 3);
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    append(bytes, mesh.triangles[t].data(), 3);
    std::array<std::uint32_t, 3> neighbours;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t other = across[3 * t + k];
      neighbours[k] = other == kNoNeighbour ? kNoNeighbour : other / 3;
    }
    append(bytes, neighbours.data(), 3);
  }
  const std::array<float, 6> box = {low.x(), high.x(), low.y(), high.y(), low.z(), high.z()};
  append(bytes, box.data(), box.size());
  return bytes;
}

}  // namespace swept
