// SPDX-License-Identifier: LGPL-2.1-or-later
#include "check/mesh_topology.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <atomic>
#include <numeric>

#include "base/union_find.h"

namespace swept {
namespace {

constexpr std::size_t kGrain = 1 << 13;
using Range = tbb::blocked_range<std::size_t>;

struct EdgeSums {
  std::int64_t open = 0, nonManifold = 0, odd = 0, misoriented = 0;
};

EdgeSums joinEdges(const EdgeTable& edges, RawArray<std::uint32_t>& across, RunContext& run) {
  auto count = [&](const Range& range, EdgeSums sums) {
    run.checkpoint(Phase::Check);
    edges.forEachEdge(
        static_cast<std::int64_t>(range.begin()), static_cast<std::int64_t>(range.end()),
        [&](std::int32_t, std::int32_t, const std::uint64_t* first, const std::uint64_t* last) {
          const std::int64_t n = last - first;
          if (n == 2) {
            const auto h = static_cast<std::uint32_t>(EdgeTable::halfEdge(first[0]));
            const auto g = static_cast<std::uint32_t>(EdgeTable::halfEdge(first[1]));
            across[h] = g;
            across[g] = h;
            sums.misoriented += EdgeTable::ascending(first[0]) == EdgeTable::ascending(first[1]);
            return;
          }
          sums.open += n == 1;
          sums.nonManifold += n > 2;
          sums.odd += n % 2;
          std::int64_t up = 0;
          for (const std::uint64_t* r = first; r != last; ++r) up += EdgeTable::ascending(*r);
          sums.misoriented += n > 2 && 2 * up != n;
        });
    return sums;
  };
  return tbb::parallel_reduce(Range(0, static_cast<std::size_t>(edges.vertexCount()), kGrain),
                              EdgeSums{}, count, [](EdgeSums a, const EdgeSums& b) {
                                a.open += b.open;
                                a.nonManifold += b.nonManifold;
                                a.odd += b.odd;
                                a.misoriented += b.misoriented;
                                return a;
                              });
}

void joinAll(const TriMesh& mesh, MeshTopology& topology, RunContext& run) {
  const EdgeTable edges(mesh.triangles, static_cast<std::int64_t>(mesh.vertices.size()));
  topology.across = RawArray<std::uint32_t>(3 * mesh.triangles.size());
  tbb::parallel_for(Range(0, topology.across.size(), 1 << 16), [&](const Range& range) {
    std::fill(topology.across.data() + range.begin(), topology.across.data() + range.end(),
              kNoNeighbour);
  });
  const EdgeSums sums = joinEdges(edges, topology.across, run);
  topology.openEdges = sums.open;
  topology.nonManifoldEdges = sums.nonManifold;
  topology.oddEdges = sums.odd;
  topology.misorientedEdges = sums.misoriented;
}

std::uint32_t nextHalfEdge(std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
std::uint32_t previousHalfEdge(std::uint32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }

/// The triangles round one vertex, as the corners (half-edges that start at it) met on the way.
struct Fan {
  std::vector<std::uint32_t> corners;
  bool cycle = false;       ///< came back to the start
  bool consistent = false;  ///< every step led to a triangle of the same orientation
};

/// Walks from `start` over edges with two triangles; `forward`: counter-clockwise first.
void walk(const TriMesh& mesh, const RawArray<std::uint32_t>& across, std::uint32_t start,
          bool forward, Fan& fan) {
  const std::int32_t v = mesh.triangles[start / 3][start % 3];
  std::uint32_t corner = start;
  for (;;) {
    const std::uint32_t other = across[forward ? previousHalfEdge(corner) : corner];
    if (other == kNoNeighbour) return;
    const bool starts = mesh.triangles[other / 3][other % 3] == v;
    // Leaving through the incoming edge, a consistent neighbour has it as its outgoing one.
    if (starts != forward) fan.consistent = false;
    const std::uint32_t next = starts ? other : nextHalfEdge(other);
    forward = starts;
    if (next == start) {
      fan.cycle = true;
      return;
    }
    fan.corners.push_back(next);
    corner = next;
  }
}

/// True if, seen against the mean normal, the fan goes once round its vertex without turning back:
/// its triangles then share nothing but their common edges. Margins are far above rounding, so a
/// "true" is certain; a "false" means only that a closer look is needed.
bool isDisc(const TriMesh& mesh, const Fan& fan) {
  if (!fan.cycle || !fan.consistent || fan.corners.size() < 3) return false;
  const std::uint32_t first = fan.corners[0];
  const Eigen::Vector3d v = mesh.vertices[mesh.triangles[first / 3][first % 3]];
  auto arm = [&](std::uint32_t corner, std::uint32_t step) -> Eigen::Vector3d {
    return mesh.vertices[mesh.triangles[corner / 3][(corner % 3 + step) % 3]] - v;
  };
  Eigen::Vector3d n = Eigen::Vector3d::Zero();
  Eigen::Vector3d start = arm(first, 1);
  Eigen::Vector3d out = start;
  for (const std::uint32_t corner : fan.corners) {
    const Eigen::Vector3d in = arm(corner, 2);
    n += out.cross(in);
    out = in;
  }
  // A direction of the plane across n: exactly perpendicular to n, and not short.
  int a = 0;
  n.cwiseAbs().maxCoeff(&a);
  const int b = (a + 1) % 3;
  const double wa = n[b], wb = -n[a];
  const double size = n.cwiseAbs().sum();
  out = start;
  int turns = 0;
  bool above = wa * out[a] + wb * out[b] >= 0;
  for (const std::uint32_t corner : fan.corners) {
    const Eigen::Vector3d in = arm(corner, 2);
    if (!(n.dot(out.cross(in)) > 1e-12 * size * (out.squaredNorm() + in.squaredNorm()))) {
      return false;
    }
    const bool aboveIn = wa * in[a] + wb * in[b] >= 0;
    turns += !above && aboveIn;
    above = aboveIn;
    out = in;
  }
  return turns == 1;
}

/// One corner of every vertex; which one does not matter for what is made of it.
std::vector<std::uint32_t> someCorner(const TriMesh& mesh) {
  std::vector<std::uint32_t> corner(mesh.vertices.size(), kNoNeighbour);
  tbb::parallel_for(Range(0, mesh.triangles.size(), kGrain), [&](const Range& range) {
    for (std::size_t t = range.begin(); t != range.end(); ++t) {
      for (std::uint32_t k = 0; k < 3; ++k) {
        std::atomic_ref<std::uint32_t>(corner[mesh.triangles[t][k]])
            .store(static_cast<std::uint32_t>(3 * t) + k, std::memory_order_relaxed);
      }
    }
  });
  return corner;
}

void walkFans(const TriMesh& mesh, bool withEntangled, MeshTopology& topology, RunContext& run) {
  const std::vector<std::uint32_t> corner = someCorner(mesh);
  std::vector<std::uint8_t> seen(3 * mesh.triangles.size(), 0);
  topology.entangled.assign(withEntangled ? mesh.vertices.size() : 0, 0);
  std::atomic<std::int64_t> unused{0};
  tbb::parallel_for(Range(0, mesh.vertices.size(), kGrain), [&](const Range& range) {
    run.checkpoint(Phase::Check);
    Fan fan;
    std::int64_t unusedHere = 0;
    for (std::size_t v = range.begin(); v != range.end(); ++v) {
      if (corner[v] == kNoNeighbour) {
        ++unusedHere;
        continue;
      }
      fan.corners.assign(1, corner[v]);
      fan.cycle = false;
      fan.consistent = true;
      walk(mesh, topology.across, corner[v], true, fan);
      if (!fan.cycle) walk(mesh, topology.across, corner[v], false, fan);
      for (const std::uint32_t c : fan.corners) seen[c] = 1;
      if (withEntangled) topology.entangled[v] = !isDisc(mesh, fan);
    }
    unused += unusedHere;
  });
  topology.unusedVertices = unused.load();
  // Corners that no walk met belong to vertices with a second fan.
  std::vector<std::int32_t> second;
  for (auto it = seen.begin(); (it = std::find(it, seen.end(), 0)) != seen.end(); ++it) {
    const auto c = static_cast<std::size_t>(it - seen.begin());
    second.push_back(mesh.triangles[c / 3][c % 3]);
  }
  std::sort(second.begin(), second.end());
  second.erase(std::unique(second.begin(), second.end()), second.end());
  topology.nonManifoldVertices = static_cast<std::int64_t>(second.size());
  if (!withEntangled) return;
  for (const std::int32_t v : second) topology.entangled[v] = 1;
}

void findShells(const TriMesh& mesh, MeshTopology& topology, RunContext& run) {
  auto& parent = topology.shellOf;
  parent.resize(mesh.triangles.size());
  std::iota(parent.begin(), parent.end(), 0);
  tbb::parallel_for(Range(0, mesh.triangles.size(), kGrain), [&](const Range& range) {
    run.checkpoint(Phase::Check);
    for (std::size_t t = range.begin(); t != range.end(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t other = topology.across[3 * t + k];
        if (other == kNoNeighbour || other / 3 >= t) continue;
        unite(parent, static_cast<std::int32_t>(t), static_cast<std::int32_t>(other / 3));
      }
    }
  });
  // Roots come before their members, so one pass replaces links by shell numbers.
  for (std::size_t t = 0; t < parent.size(); ++t) {
    const bool root = parent[t] == static_cast<std::int32_t>(t);
    parent[t] = root ? static_cast<std::int32_t>(topology.shells++) : parent[parent[t]];
  }
}

}  // namespace

MeshTopology findTopology(const TriMesh& mesh, bool withEntangled, RunContext& run) {
  MeshTopology topology;
  joinAll(mesh, topology, run);
  walkFans(mesh, withEntangled, topology, run);
  findShells(mesh, topology, run);
  return topology;
}

}  // namespace swept
