// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/mesh_numbers.h"

#include <algorithm>

#include "base/number_text.h"
#include "base/parallel.h"

namespace swept {
namespace {

constexpr std::size_t kCheckBlock = 1 << 14;
constexpr std::size_t kMaxListed = 8;

}  // namespace

std::optional<BadIndex> findBadIndex(const TriMesh& mesh) {
  const auto count = static_cast<std::int64_t>(mesh.vertices.size());
  std::vector<std::optional<BadIndex>> parts(mesh.triangles.size() / kCheckBlock + 1);
  parallelBlocks(mesh.triangles.size(), kCheckBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      for (const std::int32_t v : mesh.triangles[t]) {
        if (v >= 0 && v < count) continue;
        parts[begin / kCheckBlock] = BadIndex{static_cast<std::int64_t>(t), v};
        return;
      }
    }
  });
  for (const auto& part : parts) {
    if (part) return part;
  }
  return std::nullopt;
}

std::string badIndexText(const BadIndex& bad, const TriMesh& mesh) {
  return "triangle " + std::to_string(bad.triangle) + " refers to vertex " +
         std::to_string(bad.vertex) + ", but the mesh has " +
         counted(std::ssize(mesh.vertices), "vertex", "vertices") +
         " (triangles and vertices are counted from 0)";
}

Coordinates measureCoordinates(const TriMesh& mesh) {
  std::vector<Coordinates> parts(mesh.vertices.size() / kCheckBlock + 1);
  parallelBlocks(mesh.vertices.size(), kCheckBlock, [&](std::size_t begin, std::size_t end) {
    Coordinates& part = parts[begin / kCheckBlock];
    for (std::size_t v = begin; v < end; ++v) {
      const auto vertex = static_cast<std::int64_t>(v);
      if (!mesh.vertices[v].allFinite()) {
        ++part.nonFinite;
        if (part.firstNonFinite.size() < kMaxListed) part.firstNonFinite.push_back(vertex);
        continue;
      }
      const double size = mesh.vertices[v].cwiseAbs().maxCoeff();
      if (part.farthest >= 0 && !(size > part.largest)) continue;
      part.largest = size;
      part.farthest = vertex;
    }
  });
  Coordinates all;
  for (const Coordinates& part : parts) {
    all.nonFinite += part.nonFinite;
    for (const std::int64_t v : part.firstNonFinite) {
      if (all.firstNonFinite.size() < kMaxListed) all.firstNonFinite.push_back(v);
    }
    if (part.farthest < 0 || (all.farthest >= 0 && !(part.largest > all.largest))) continue;
    all.largest = part.largest;
    all.farthest = part.farthest;
  }
  return all;
}

}  // namespace swept
