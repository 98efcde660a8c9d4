// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/mend/keep_triangles.h"

#include <algorithm>
#include <atomic>

#include "base/parallel.h"

namespace swept {
namespace {

constexpr std::size_t kKeptBlock = 1 << 14;

/// Keeps the entries of `values` that have a new number (not -1).
template <class T>
void compact(std::vector<T>& values, const std::vector<std::int32_t>& number) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (number[i] >= 0) values[kept++] = values[i];
  }
  values.resize(kept);
}

/// Numbers the kept entries in their order; the other entries get -1.
std::vector<std::int32_t> numberKept(const std::vector<std::uint8_t>& kept) {
  std::vector<std::int32_t> number(kept.size());
  std::int32_t next = 0;
  for (std::size_t i = 0; i < kept.size(); ++i) number[i] = kept[i] != 0 ? next++ : -1;
  return number;
}

}  // namespace

void keepTriangles(Surface& surface, const std::vector<std::uint8_t>& keeps,
                   SelfIntersections& pairs) {
  TriMesh& mesh = surface.mesh;
  std::vector<std::uint8_t> keepsVertex(mesh.vertices.size());
  parallelBlocks(mesh.triangles.size(), kKeptBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      if (keeps[t] == 0) continue;
      for (const std::int32_t v : mesh.triangles[t]) {
        std::atomic_ref<std::uint8_t>(keepsVertex[v]).store(1, std::memory_order_relaxed);
      }
    }
  });
  const auto triangle = numberKept(keeps), vertex = numberKept(keepsVertex);
  compact(mesh.triangles, triangle);
  compact(surface.crossingOf, triangle);
  parallelBlocks(mesh.triangles.size(), kKeptBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      for (std::int32_t& v : mesh.triangles[t]) v = vertex[v];
    }
  });
  surface.dualVertices = static_cast<std::size_t>(std::count_if(
      vertex.begin(), vertex.begin() + static_cast<std::ptrdiff_t>(surface.dualVertices),
      [](std::int32_t v) { return v >= 0; }));
  compact(mesh.vertices, vertex);
  compact(surface.contactTime, vertex);
  compact(surface.cellFlags, vertex);
  std::vector<std::int32_t> mended;
  for (const std::int32_t v : surface.mended) {
    if (vertex[v] >= 0) mended.push_back(vertex[v]);
  }
  surface.mended = std::move(mended);
  SelfIntersections left;
  for (const auto& [a, b] : pairs.pairs) {
    if (triangle[a] >= 0 && triangle[b] >= 0) left.pairs.emplace_back(triangle[a], triangle[b]);
  }
  left.count = pairs.count - static_cast<std::int64_t>(pairs.pairs.size() - left.pairs.size());
  pairs = left;
}

}  // namespace swept
