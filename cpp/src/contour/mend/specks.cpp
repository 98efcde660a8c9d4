// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/mend/specks.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <unordered_map>

#include "base/parallel.h"
#include "base/raw_array.h"
#include "base/union_find.h"
#include "check/mesh_check.h"

namespace swept {
namespace {

constexpr double kMaxSize = 2;    ///< cells
constexpr double kMaxTurned = 4;  ///< cells

constexpr std::size_t kBlock = 1 << 14;

/// Per vertex: the smallest vertex of its shell.
std::vector<std::int32_t> shellsOf(const TriMesh& mesh, RunContext& run) {
  std::vector<std::int32_t> shell(mesh.vertices.size());
  std::iota(shell.begin(), shell.end(), 0);
  parallelBlocks(mesh.triangles.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    run.checkpoint(Phase::Check);
    for (std::size_t t = begin; t < end; ++t) {
      const auto& [a, b, c] = mesh.triangles[t];
      unite(shell, a, b);
      unite(shell, b, c);
    }
  });
  for (std::size_t v = 0; v < shell.size(); ++v) shell[v] = shell[shell[v]];
  return shell;
}

/// A shell, or what one block of vertices holds of it, known by its smallest vertex.
struct Shell {
  std::int32_t first = -1;
  Eigen::AlignedBox3d box;
};

/// All shells, by their smallest vertices.
std::vector<Shell> boxesOf(const TriMesh& mesh, const std::vector<std::int32_t>& shellOf) {
  std::vector<std::vector<Shell>> parts(mesh.vertices.size() / kBlock + 1);
  parallelBlocks(mesh.vertices.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    std::vector<Shell>& part = parts[begin / kBlock];
    std::unordered_map<std::int32_t, std::size_t> places;
    std::size_t at = 0;
    for (std::size_t v = begin; v < end; ++v) {
      if (part.empty() || part[at].first != shellOf[v]) {
        const auto [place, fresh] = places.try_emplace(shellOf[v], part.size());
        if (fresh) part.push_back({shellOf[v], {}});
        at = place->second;
      }
      part[at].box.extend(mesh.vertices[v]);
    }
  });
  std::vector<Shell> all;
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
  std::stable_sort(all.begin(), all.end(),
                   [](const Shell& a, const Shell& b) { return a.first < b.first; });
  std::size_t kept = 0;
  for (std::size_t n = 0; n < all.size(); ++n) {
    if (kept > 0 && all[kept - 1].first == all[n].first) {
      all[kept - 1].box.extend(all[n].box);
    } else {
      all[kept++] = all[n];
    }
  }
  all.resize(kept);
  return all;
}

/// Six times the volumes of the small shells, by smallest vertex; none of a shell without
/// triangles.
std::unordered_map<std::int32_t, double> volumesOf(const TriMesh& mesh,
                                                   const std::vector<std::int32_t>& shellOf,
                                                   const std::vector<bool>& small) {
  std::vector<std::vector<std::size_t>> parts(mesh.triangles.size() / kBlock + 1);
  parallelBlocks(mesh.triangles.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      if (small[shellOf[mesh.triangles[t][0]]]) parts[begin / kBlock].push_back(t);
    }
  });
  struct Sum {
    Eigen::Vector3d origin;  // near, so that little is lost
    double volume = 0;
  };
  std::unordered_map<std::int32_t, Sum> sums;
  for (const auto& part : parts) {
    for (const std::size_t t : part) {
      const auto& [a, b, c] = mesh.triangles[t];
      Sum& sum = sums.try_emplace(shellOf[a], Sum{mesh.vertices[a]}).first->second;
      const Eigen::Vector3d p = mesh.vertices[a] - sum.origin, q = mesh.vertices[b] - sum.origin,
                            r = mesh.vertices[c] - sum.origin;
      sum.volume += p.dot(q.cross(r));
    }
  }
  std::unordered_map<std::int32_t, double> out;
  for (const auto& [first, sum] : sums) out.emplace(first, sum.volume);
  return out;
}

/// Marks the shells that go, by their smallest vertices.
std::vector<bool> findSpecks(const TriMesh& mesh, const std::vector<std::int32_t>& shellOf,
                             double cell, double mostVolume, Specks& found) {
  std::vector<bool> speck(mesh.vertices.size());
  const std::vector<Shell> shells = boxesOf(mesh, shellOf);
  if (shells.size() < 2) return speck;
  const auto sizeOf = [&](const Shell& shell) { return shell.box.diagonal().norm() / cell; };
  std::vector<bool> small(mesh.vertices.size());
  for (const Shell& shell : shells) small[shell.first] = sizeOf(shell) < kMaxSize;
  const std::unordered_map<std::int32_t, double> volumes = volumesOf(mesh, shellOf, small);
  bool others = false;
  for (const Shell& shell : shells) {
    const auto sum = volumes.find(shell.first);
    if (small[shell.first] && sum == volumes.end()) continue;  // no triangle
    const double volume =
        small[shell.first] ? std::abs(sum->second) / 6 / (cell * cell * cell) : HUGE_VAL;
    if (volume >= mostVolume) {
      others = true;
      continue;
    }
    speck[shell.first] = true;
    ++found.count;
    found.largestVolume = std::max(found.largestVolume, volume);
    found.largestSize = std::max(found.largestSize, sizeOf(shell));
  }
  if (!others) found = {};
  return speck;
}

/// Keeps the entries of `values` that have a new number.
template <class T>
void compact(std::vector<T>& values, const RawArray<std::int32_t>& number) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < values.size();) {
    if (number[i] < 0) {
      ++i;
      continue;
    }
    std::size_t end = i + 1;
    while (end < values.size() && number[end] >= 0) ++end;
    const auto from = values.begin() + static_cast<std::ptrdiff_t>(i);
    const auto length = static_cast<std::ptrdiff_t>(end - i);
    if (kept != i) {
      std::copy(from, from + length, values.begin() + static_cast<std::ptrdiff_t>(kept));
    }
    kept += end - i;
    i = end;
  }
  values.resize(kept);
}

/// The kept ones are numbered in their order; -1: not kept.
RawArray<std::int32_t> numberKept(const std::vector<std::uint8_t>& kept) {
  RawArray<std::int32_t> number(kept.size());
  std::vector<std::int32_t> next(kept.size() / kBlock + 1, 0);
  parallelBlocks(kept.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    std::int32_t count = 0;
    for (std::size_t i = begin; i < end; ++i) count += kept[i];
    next[begin / kBlock] = count;
  });
  exclusiveScan(next);
  parallelBlocks(kept.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    std::int32_t at = next[begin / kBlock];
    for (std::size_t i = begin; i < end; ++i) number[i] = kept[i] != 0 ? at++ : -1;
  });
  return number;
}

}  // namespace

Specks dropSpecks(Surface& surface, double cell, double mostVolume, SelfIntersections& pairs,
                  RunContext& run) {
  Specks found;
  TriMesh& mesh = surface.mesh;
  const std::vector<std::int32_t> shellOf = shellsOf(mesh, run);
  const std::vector<bool> speck = findSpecks(mesh, shellOf, cell, mostVolume, found);
  if (found.count == 0) return found;
  std::vector<std::uint8_t> keepsTriangle(mesh.triangles.size()), keepsVertex(mesh.vertices.size());
  parallelBlocks(mesh.triangles.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      if (speck[shellOf[mesh.triangles[t][0]]]) continue;
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
      vertex.data(), vertex.data() + surface.dualVertices, [](std::int32_t v) { return v >= 0; }));
  compact(mesh.vertices, vertex);
  compact(surface.contactTime, vertex);
  compact(surface.lodging, vertex);
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
  std::vector<bool> turned(static_cast<std::size_t>(topology.shells));
  for (const InsideOutShell& found : shellsInsideOut(surface.mesh, topology, run)) {
    if (found.size < kMaxTurned * cell) turned[found.shell] = true;
  }
  for (std::size_t t = 0; t < surface.mesh.triangles.size(); ++t) {
    if (!turned[topology.shellOf[t]]) continue;
    auto& [a, b, c] = surface.mesh.triangles[t];
    std::swap(b, c);
  }
  return std::count(turned.begin(), turned.end(), true);
}

}  // namespace swept
