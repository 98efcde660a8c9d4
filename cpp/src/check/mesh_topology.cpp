// SPDX-License-Identifier: LGPL-2.1-or-later
#include "check/mesh_topology.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>

#include "base/sort_unique.h"

namespace swept {
namespace {

constexpr std::size_t kGrain = 1 << 13;
using Range = tbb::blocked_range<std::size_t>;

/// The triangles round one vertex, in the order in which walk() visits them. Each is given by its
/// corner: the half-edge that starts at the vertex.
struct Fan {
  std::vector<std::uint32_t> corners;
  bool cycle = false;       ///< the walk came back to its start
  bool consistent = false;  ///< every step led to a triangle of the same orientation
};

/// Walks round a vertex from the corner `start`, over edges with two triangles, and appends the
/// corners to `fan`. The walk starts counter-clockwise if `forward` is set, else clockwise.
void walk(const TriMesh& mesh, const RawArray<std::uint32_t>& across, std::uint32_t start,
          bool forward, Fan& fan) {
  const std::int32_t v = mesh.triangles[start / 3][start % 3];
  std::uint32_t corner = start;
  for (;;) {
    const std::uint32_t other = across[forward ? previousHalfEdge(corner) : corner];
    if (other == kNoNeighbour) return;
    const bool starts = mesh.triangles[other / 3][other % 3] == v;
    // A neighbour with the same orientation has the common edge in the opposite direction.
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

/// Returns true if the fan, projected along its mean normal, goes once round its vertex without
/// turning back. Its triangles then meet only in their common edges and in the vertex. Margins are
/// far above rounding, so "true" is certain; "false" only means that exact tests must decide.
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
  // The vector with the components wa and wb along the axes a and b, and 0 along the third axis, is
  // exactly perpendicular to n. It is not short, because wb is the largest component of n.
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

/// Returns any one corner of every vertex; kNoNeighbour for a vertex without triangles. The choice
/// does not change the result of the check.
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
      walk(mesh, topology.adjacency.across, corner[v], true, fan);
      if (!fan.cycle) walk(mesh, topology.adjacency.across, corner[v], false, fan);
      for (const std::uint32_t c : fan.corners) seen[c] = 1;
      if (withEntangled) topology.entangled[v] = !isDisc(mesh, fan);
    }
    unused += unusedHere;
  });
  topology.unusedVertices = unused.load();
  // Corners that no walk reached belong to vertices with a second fan.
  std::vector<std::int32_t> second;
  for (auto it = seen.begin(); (it = std::find(it, seen.end(), 0)) != seen.end(); ++it) {
    const auto c = static_cast<std::size_t>(it - seen.begin());
    second.push_back(mesh.triangles[c / 3][c % 3]);
  }
  sortUnique(second);
  topology.nonManifoldVertices = static_cast<std::int64_t>(second.size());
  if (!withEntangled) return;
  for (const std::int32_t v : second) topology.entangled[v] = 1;
}

}  // namespace

MeshTopology findTopology(const TriMesh& mesh, bool withEntangled, RunContext& run) {
  MeshTopology topology;
  topology.adjacency = findAdjacency(mesh);
  run.checkpoint(Phase::Check);
  walkFans(mesh, withEntangled, topology, run);
  topology.shells = shellsByEdges(topology.adjacency.across);
  return topology;
}

}  // namespace swept
