// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/mend/specks.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>

#include "base/parallel.h"
#include "check/mesh_check.h"
#include "geometry/shells.h"

namespace swept {
namespace {

constexpr double kMaxSpeckSize =
    2;  ///< cells: a shell round one or two lattice edges is not larger
/// Cells: larger shells that are inside out are left for the checker to report.
constexpr double kMaxTurnedSize = 4;

constexpr std::size_t kBlock = 1 << 14;

/// Marks the shells to drop.
std::vector<bool> findSpecks(const std::vector<ShellExtent>& shells, double cell, double maxVolume,
                             Specks& found) {
  std::vector<bool> speck(shells.size());
  bool others = false;
  for (std::size_t s = 0; s < shells.size(); ++s) {
    const double size = shells[s].box.diagonal().norm() / cell;
    const double volume = std::abs(shells[s].volume) / (cell * cell * cell);
    if (size >= kMaxSpeckSize || volume >= maxVolume) {
      others = true;
      continue;
    }
    speck[s] = true;
    ++found.count;
    found.largestVolume = std::max(found.largestVolume, volume);
    found.largestSize = std::max(found.largestSize, size);
  }
  if (!others) found = {};
  return speck;
}

/// Keeps the entries of `values` that have a new number.
template <class T>
void compact(std::vector<T>& values, const std::vector<std::int32_t>& number) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (number[i] >= 0) values[kept++] = values[i];
  }
  values.resize(kept);
}

/// Numbers the kept entries in their order; -1 for the others.
std::vector<std::int32_t> numberKept(const std::vector<std::uint8_t>& kept) {
  std::vector<std::int32_t> number(kept.size());
  std::int32_t next = 0;
  for (std::size_t i = 0; i < kept.size(); ++i) number[i] = kept[i] != 0 ? next++ : -1;
  return number;
}

}  // namespace

Specks dropSpecks(Surface& surface, double cell, double maxVolume, SelfIntersections& pairs,
                  RunContext& run) {
  Specks found;
  TriMesh& mesh = surface.mesh;
  run.checkpoint(Phase::Check);
  const Shells shells = shellsByVertices(mesh);
  if (shells.count < 2) return found;
  const std::vector<bool> speck = findSpecks(measureShells(mesh, shells), cell, maxVolume, found);
  if (found.count == 0) return found;
  std::vector<std::uint8_t> keepsTriangle(mesh.triangles.size()), keepsVertex(mesh.vertices.size());
  parallelBlocks(mesh.triangles.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      if (speck[shells.ofTriangle[t]]) continue;
      keepsTriangle[t] = 1;
      for (const std::int32_t v : mesh.triangles[t]) {
        std::atomic_ref<std::uint8_t>(keepsVertex[v]).store(1, std::memory_order_relaxed);
      }
    }
  });
  const auto triangle = numberKept(keepsTriangle), vertex = numberKept(keepsVertex);
  compact(mesh.triangles, triangle);
  compact(surface.crossingOf, triangle);
  parallelBlocks(mesh.triangles.size(), kBlock, [&](std::size_t begin, std::size_t end) {
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
  SelfIntersections left;
  for (const auto& [a, b] : pairs.pairs) {
    if (triangle[a] >= 0 && triangle[b] >= 0) left.pairs.emplace_back(triangle[a], triangle[b]);
  }
  left.count = pairs.count - static_cast<std::int64_t>(pairs.pairs.size() - left.pairs.size());
  pairs = left;
  return found;
}

std::int64_t turnInsideOut(Surface& surface, const MeshTopology& topology, double cell,
                           RunContext& run) {
  std::vector<bool> turned(static_cast<std::size_t>(topology.shells.count));
  for (const InsideOutShell& found : shellsInsideOut(surface.mesh, topology, run)) {
    if (found.size < kMaxTurnedSize * cell) turned[found.shell] = true;
  }
  for (std::size_t t = 0; t < surface.mesh.triangles.size(); ++t) {
    if (!turned[topology.shells.ofTriangle[t]]) continue;
    auto& [a, b, c] = surface.mesh.triangles[t];
    std::swap(b, c);
  }
  return std::count(turned.begin(), turned.end(), true);
}

}  // namespace swept
