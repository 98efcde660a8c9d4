// SPDX-License-Identifier: LGPL-2.1-or-later
#include "input/body_orientation.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>

#include "base/union_find.h"
#include "geometry/ray_columns.h"
#include "geometry/shells.h"

namespace swept {
namespace {

/// Groups of triangles that are connected across edges with exactly two triangles.
struct Patches {
  std::vector<std::int32_t> ofTriangle;
  std::vector<std::uint8_t> flip;               ///< per triangle: 1 if it must be reversed
  std::vector<std::uint8_t> mixed, consistent;  ///< per patch; mixed: some triangles are reversed
  std::int64_t reversed = 0;
  std::int32_t count() const { return static_cast<std::int32_t>(mixed.size()); }
};

struct Shell {
  bool closed = true;  ///< equally many triangles in both directions at every edge
  bool consistent = true;
  bool mixed = false;
  ShellExtent extent;                    ///< before any shell is reversed
  std::vector<std::int32_t> containers;  ///< closed shells that wholly contain this one
  int winding = 0;                       ///< winding number inside this shell
  bool invert = false;
};

Patches findPatches(const TriMesh& mesh, const EdgeTable& edges) {
  const RawArray<std::uint32_t> across = findAdjacency(edges).across;
  const auto originOf = [&](std::uint32_t h) { return mesh.triangles[h / 3][h % 3]; };
  Patches patches;
  patches.ofTriangle.assign(mesh.triangles.size(), -1);
  patches.flip.assign(mesh.triangles.size(), 0);
  std::vector<std::int32_t> stack;
  for (std::size_t seed = 0; seed < mesh.triangles.size(); ++seed) {
    if (patches.ofTriangle[seed] >= 0) continue;
    const std::int32_t patch = patches.count();
    bool consistent = true;
    stack.assign(1, static_cast<std::int32_t>(seed));
    patches.ofTriangle[seed] = patch;
    for (std::size_t head = 0; head < stack.size(); ++head) {
      const std::int32_t t = stack[head];
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t h = 3 * static_cast<std::uint32_t>(t) + k, g = across[h];
        if (g == kNoNeighbour) continue;
        const auto other = static_cast<std::int32_t>(g / 3);
        const bool sameDirection = originOf(h) == originOf(g);
        const std::uint8_t wanted = (patches.flip[t] != 0) != sameDirection ? 1 : 0;
        if (patches.ofTriangle[other] < 0) {
          patches.ofTriangle[other] = patch;
          patches.flip[other] = wanted;
          stack.push_back(other);
        } else if (patches.flip[other] != wanted) {
          consistent = false;
        }
      }
    }
    std::size_t flips = 0;
    for (const std::int32_t t : stack) flips += patches.flip[t];
    // The orientation of the majority is kept. In a tie, the triangles that agree with the first
    // one keep theirs.
    const bool other = 2 * flips > stack.size();
    for (const std::int32_t t : stack) {
      patches.flip[t] = consistent && (patches.flip[t] != 0) != other ? 1 : 0;
    }
    if (consistent) patches.reversed += std::min(flips, stack.size() - flips);
    patches.mixed.push_back(consistent && flips > 0);
    patches.consistent.push_back(consistent);
  }
  return patches;
}

/// Joins patches at edges that do not have exactly two triangles. A patch is balanced at an edge if
/// equally many of its triangles run along the edge in each direction. Patches that are not
/// balanced at an edge are joined there. Returns the shell of each patch.
std::vector<std::int32_t> joinPatches(const EdgeTable& edges, const Patches& patches,
                                      std::vector<Shell>& shells) {
  auto parent = singleSets<std::int32_t>(patches.count());
  std::vector<std::pair<std::int32_t, int>> sums;  // patch, direction
  auto balance = [&](const std::uint64_t* first, const std::uint64_t* last, auto&& key) {
    sums.clear();
    for (const std::uint64_t* r = first; r != last; ++r) {
      const std::int64_t t = EdgeTable::halfEdge(*r) / 3;
      const bool up = EdgeTable::ascending(*r) != (patches.flip[t] != 0);
      sums.emplace_back(key(patches.ofTriangle[t]), up ? 1 : -1);
    }
    std::sort(sums.begin(), sums.end());
    std::size_t kept = 0;
    for (std::size_t i = 0; i < sums.size();) {
      auto sum = sums[i];
      for (++i; i < sums.size() && sums[i].first == sum.first; ++i) sum.second += sums[i].second;
      if (sum.second != 0) sums[kept++] = sum;
    }
    sums.resize(kept);
  };
  edges.forEachEdge(
      [&](std::int32_t, std::int32_t, const std::uint64_t* first, const std::uint64_t* last) {
        if (last - first == 2) return;
        balance(first, last, [](std::int32_t patch) { return patch; });
        for (std::size_t i = 1; i < sums.size(); ++i) {
          unite(parent, sums[0].first, sums[i].first);
        }
      });
  std::vector<std::int32_t> shellOf(patches.count());
  for (std::int32_t p = 0; p < patches.count(); ++p) {
    const std::int32_t root = findRoot(parent, p);
    if (root == p) {
      shellOf[p] = static_cast<std::int32_t>(shells.size());
      shells.emplace_back();
    } else {
      shellOf[p] = shellOf[root];
    }
    Shell& shell = shells[shellOf[p]];
    shell.mixed = shell.mixed || patches.mixed[p] != 0;
    shell.consistent = shell.consistent && patches.consistent[p] != 0;
  }
  edges.forEachEdge(
      [&](std::int32_t, std::int32_t, const std::uint64_t* first, const std::uint64_t* last) {
        if (last - first == 2) return;
        balance(first, last, [&](std::int32_t patch) { return shellOf[patch]; });
        for (const auto& sum : sums) shells[sum.first].closed = false;
      });
  return shellOf;
}

/// Returns three triangles of each shell: its first, middle and last one.
std::vector<std::vector<std::int32_t>> sampleShells(const Shells& shells) {
  std::vector<std::int64_t> sizes(shells.count, 0), seen(shells.count, 0);
  for (const std::int32_t s : shells.ofTriangle) ++sizes[s];
  std::vector<std::vector<std::int32_t>> samples(shells.count);
  for (std::size_t t = 0; t < shells.ofTriangle.size(); ++t) {
    const std::int32_t s = shells.ofTriangle[t];
    const std::int64_t n = seen[s]++;
    if (n == 0 || n == sizes[s] / 2 || n == sizes[s] - 1) {
      samples[s].push_back(static_cast<std::int32_t>(t));
    }
  }
  return samples;
}

void findContainers(const ShellNesting& nesting,
                    const std::vector<std::vector<std::int32_t>>& samples,
                    std::vector<Shell>& shells, RunContext& run) {
  std::vector<std::size_t> votes(shells.size(), 0);
  for (std::size_t s = 0; s < shells.size(); ++s) {
    if (s % 64 == 0) run.checkpoint(Phase::Input, s, shells.size());
    Shell& inner = shells[s];
    std::vector<std::int32_t> candidates;
    for (std::size_t o = 0; o < shells.size(); ++o) {
      if (o != s && shells[o].closed &&
          liesStrictlyInside(inner.extent.box, shells[o].extent.box)) {
        candidates.push_back(static_cast<std::int32_t>(o));
      }
    }
    if (candidates.empty()) continue;
    for (const std::int32_t c : candidates) votes[c] = 0;
    for (const std::int32_t t : samples[s]) {
      for (const std::int32_t c : nesting.shellsAround(t)) ++votes[c];
    }
    // A shell is nested only if all its samples lie inside the other one; otherwise the two
    // overlap.
    for (const std::int32_t c : candidates) {
      if (votes[c] == samples[s].size()) inner.containers.push_back(c);
    }
  }
}

/// Decides which shells to reverse. Outer shells must point outward. An inner shell is a cavity,
/// and must point inward, if its orientation in the file is opposite to that of its outermost
/// container.
void decideShells(std::vector<Shell>& shells, OrientationResult& result) {
  std::vector<std::int32_t> order(shells.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
    return shells[a].containers.size() < shells[b].containers.size();
  });
  for (const std::int32_t s : order) {
    Shell& shell = shells[s];
    if (!shell.closed || !shell.consistent) continue;
    std::int32_t direct = -1, outermost = -1;
    for (const std::int32_t c : shell.containers) {
      if (direct < 0 || shells[c].containers.size() > shells[direct].containers.size()) direct = c;
      if (outermost < 0 || shells[c].containers.size() < shells[outermost].containers.size()) {
        outermost = c;
      }
    }
    const int around = direct < 0 ? 0 : std::max(0, shells[direct].winding);
    bool cavity = false;
    if (around > 0) {
      const bool opposite = (shell.extent.volume < 0) != (shells[outermost].extent.volume < 0);
      // If some triangles of a shell had to be reversed, its orientation in the file means nothing.
      // Then the nesting decides.
      cavity = shell.mixed || shells[outermost].mixed ? around == 1 : opposite;
      cavity ? ++result.cavities : ++result.nested;
    }
    shell.winding = cavity ? around - 1 : around + 1;
    shell.invert = cavity != (shell.extent.volume < 0);
    if (shell.invert) ++result.inverted;
  }
}

/// Returns true if sample lines never enter a shell from its wrong side. A shell that intersects
/// itself can have parts that are inside out although its volume is positive.
bool isWindingConsistent(const RayColumns& columns,
                         const std::vector<std::int32_t>& shellOfTriangle,
                         const std::vector<Shell>& shells) {
  constexpr int kLines = 96;  // number of lines along each side of the box
  std::atomic<bool> consistent{true};
  const Eigen::Vector3d extent = columns.high() - columns.low();
  const double samePosition = 1e-9 * extent.norm();
  tbb::parallel_for(0, kLines, [&](int row) {
    std::vector<RayColumns::Crossing> line;
    std::vector<std::pair<std::int32_t, int>> sums;
    for (int i = 0; i < kLines && consistent.load(std::memory_order_relaxed); ++i) {
      const double y = columns.low().y() + extent.y() * (i + 0.4831) / kLines;
      const double z = columns.low().z() + extent.z() * (row + 0.5173) / kLines;
      columns.crossings(y, z, line);
      sums.clear();
      for (const auto& crossing : line) {
        const std::int32_t s = shellOfTriangle[crossing.triangle];
        auto it = std::find_if(sums.begin(), sums.end(), [&](auto& e) { return e.first == s; });
        if (it == sums.end()) it = sums.insert(sums.end(), {s, 0});
        // A cavity counts with the opposite sign. Crossings at one position may come in any order,
        // so the sums are tested only after the last of them.
        it->second += shells[s].winding < 1 ? -crossing.direction : crossing.direction;
        const bool last = &crossing == &line.back() || (&crossing)[1].x > crossing.x + samePosition;
        if (last) {
          for (const auto& e : sums) {
            if (e.second < 0) consistent.store(false, std::memory_order_relaxed);
          }
        }
      }
    }
  });
  return consistent.load();
}

}  // namespace

EdgeCounts countEdges(const EdgeTable& edges) {
  EdgeCounts counts;
  counts.openVertices.assign(static_cast<std::size_t>(edges.vertexCount()), 0);
  auto note = [](std::vector<std::int64_t>& list, std::int32_t v) {
    if (list.size() < 8) list.push_back(v);
  };
  edges.forEachEdge([&](std::int32_t low, std::int32_t high, const std::uint64_t* first,
                        const std::uint64_t* last) {
    const std::int64_t n = last - first;
    if (n % 2 != 0) {
      ++counts.open;
      note(counts.firstOpen, low);
      counts.openVertices[low] = counts.openVertices[high] = 1;
    }
    if (n > 2) {
      ++counts.nonManifold;
      note(counts.firstNonManifold, low);
    }
  });
  return counts;
}

OrientationResult orientShells(TriMesh& mesh, const EdgeTable& edges, bool closed,
                               RunContext& run) {
  run.checkpoint(Phase::Input);
  const Patches patches = findPatches(mesh, edges);
  OrientationResult result;
  result.mixed = patches.reversed;
  std::vector<Shell> shells;
  const std::vector<std::int32_t> shellOfPatch = joinPatches(edges, patches, shells);
  Shells numbers{std::vector<std::int32_t>(mesh.triangles.size()),
                 static_cast<std::int32_t>(shells.size())};
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    numbers.ofTriangle[t] = shellOfPatch[patches.ofTriangle[t]];
    if (patches.flip[t] != 0) std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
  }
  run.checkpoint(Phase::Input);
  const std::vector<ShellExtent> extents = measureShells(mesh, numbers);
  for (std::size_t s = 0; s < shells.size(); ++s) shells[s].extent = extents[s];
  result.shells = static_cast<std::int64_t>(shells.size());

  const RayColumns columns(mesh);
  run.checkpoint(Phase::Input);
  findContainers(ShellNesting(mesh, numbers, columns), sampleShells(numbers), shells, run);
  decideShells(shells, result);
  bool valid = closed;
  for (const Shell& shell : shells) {
    if (!shell.consistent) ++result.inconsistent;
    const double size = shell.extent.box.diagonal().norm();
    if (!shell.closed || !shell.consistent ||
        std::abs(shell.extent.volume) <= 1e-13 * size * size * size) {
      valid = false;
    }
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (shells[numbers.ofTriangle[t]].invert) std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
  }
  run.checkpoint(Phase::Input);
  if (valid) result.insideOut = !isWindingConsistent(columns, numbers.ofTriangle, shells);
  result.orientable = valid && !result.insideOut;
  return result;
}

}  // namespace swept
