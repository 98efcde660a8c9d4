// SPDX-License-Identifier: LGPL-2.1-or-later
#include "check/mesh_check.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "base/threads.h"
#include "check/mesh_topology.h"
#include "geometry/exact_predicates.h"
#include "geometry/mesh_numbers.h"
#include "geometry/ray_columns.h"
#include "geometry/self_intersections.h"
#include "geometry/shells.h"
#include "swept/compute.h"

namespace swept {
namespace {

constexpr std::size_t kSumBlock = 1 << 14;

void requireValidIndices(const TriMesh& mesh) {
  const std::optional<BadIndex> bad = findBadIndex(mesh);
  if (!bad) return;
  throw Error(Status::InvalidInput, "BadIndex",
              badIndexText(*bad, mesh) + "; correct the triangles of the mesh");
}

struct Sums {
  double volume = 0, area = 0;
  std::int64_t degenerate = 0;
};

/// Sums over blocks of fixed size, then adds the sums of the blocks in order, so the result does
/// not depend on the number of threads, not even by rounding.
Sums measure(const TriMesh& mesh, const Eigen::Vector3d& origin, RunContext& run) {
  std::vector<Sums> parts((mesh.triangles.size() + kSumBlock - 1) / kSumBlock);
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t part) {
    run.checkpoint(Phase::Check);
    Sums sums;
    const std::size_t end = std::min(mesh.triangles.size(), (part + 1) * kSumBlock);
    for (std::size_t t = part * kSumBlock; t < end; ++t) {
      const auto& tri = mesh.triangles[t];
      const Eigen::Vector3d a = mesh.vertices[tri[0]] - origin;
      const Eigen::Vector3d u = mesh.vertices[tri[1]] - mesh.vertices[tri[0]];
      const Eigen::Vector3d v = mesh.vertices[tri[2]] - mesh.vertices[tri[0]];
      const Eigen::Vector3d n = u.cross(v);
      sums.volume += a.dot(n) / 6;
      const double twice = n.norm();
      sums.area += twice / 2;
      // An area far above the rounding error cannot be zero. For a smaller one, the exact test
      // decides.
      if (!(twice > 1e-14 * (u.squaredNorm() + v.squaredNorm()))) {
        sums.degenerate +=
            collinear(mesh.vertices[tri[0]], mesh.vertices[tri[1]], mesh.vertices[tri[2]]);
      }
    }
    parts[part] = sums;
  });
  Sums all;
  for (const Sums& part : parts) {
    all.volume += part.volume;
    all.area += part.area;
    all.degenerate += part.degenerate;
  }
  return all;
}

/// Returns the number of other shells that contain a point of this triangle.
int depthOf(const ShellNesting& nesting, const Shells& shells,
            const std::vector<ShellExtent>& extents, std::int32_t triangle) {
  const Eigen::AlignedBox3d& inner = extents[shells.ofTriangle[triangle]].box;
  const std::vector<std::int32_t> around = nesting.shellsAround(triangle);
  return static_cast<int>(std::count_if(around.begin(), around.end(), [&](std::int32_t s) {
    return liesStrictlyInside(inner, extents[s].box);
  }));
}

/// Returns the shells whose box lies within the box of another shell.
std::vector<std::int32_t> nestedShells(const std::vector<ShellExtent>& shells, RunContext& run) {
  std::vector<std::int32_t> byLow(shells.size());
  std::iota(byLow.begin(), byLow.end(), 0);
  std::sort(byLow.begin(), byLow.end(), [&](std::int32_t a, std::int32_t b) {
    return shells[a].box.min().x() < shells[b].box.min().x();
  });
  std::vector<std::uint8_t> isNested(shells.size(), 0);
  for (std::size_t i = 0; i < byLow.size(); ++i) {
    if (i % 256 == 0) run.checkpoint(Phase::Check);
    const Eigen::AlignedBox3d& outer = shells[byLow[i]].box;
    for (std::size_t j = i + 1; j < byLow.size(); ++j) {
      const Eigen::AlignedBox3d& inner = shells[byLow[j]].box;
      if (inner.min().x() >= outer.max().x()) break;
      if (liesStrictlyInside(inner, outer)) isNested[byLow[j]] = 1;
    }
  }
  std::vector<std::int32_t> nested;
  for (std::size_t s = 0; s < shells.size(); ++s) {
    if (isNested[s] != 0) nested.push_back(static_cast<std::int32_t>(s));
  }
  return nested;
}

/// Marks the cavities: shells inside an odd number of other shells. All other shells bound material
/// from outside.
std::vector<std::uint8_t> findCavities(const TriMesh& mesh, const Shells& shells,
                                       const std::vector<ShellExtent>& extents, RunContext& run) {
  const std::vector<std::int32_t> nested = nestedShells(extents, run);
  std::vector<std::uint8_t> cavity(extents.size(), 0);
  if (nested.empty()) return cavity;
  Eigen::AlignedBox3d region;
  for (const std::int32_t s : nested) region.extend(extents[s].box);
  const RayColumns columns(mesh, region.min(), region.max());
  const ShellNesting nesting(mesh, shells, columns);
  for (const std::int32_t s : nested) {
    run.checkpoint(Phase::Check);
    // Shells that cross each other have no well-defined depth. A shell therefore counts as a cavity
    // only if two sample points agree.
    const int depth = depthOf(nesting, shells, extents, extents[s].first);
    const bool sure = depth == depthOf(nesting, shells, extents, extents[s].last);
    cavity[s] = sure && depth % 2 == 1;
  }
  return cavity;
}

MeshCheck checkInArena(const TriMesh& mesh, MeshTopology& topology, SelfIntersections* found,
                       RunContext& run) {
  run.checkpoint(Phase::Check);
  MeshCheck check;
  check.vertices = static_cast<std::int64_t>(mesh.vertices.size());
  check.triangles = static_cast<std::int64_t>(mesh.triangles.size());
  requireValidIndices(mesh);
  check.finite = measureCoordinates(mesh).nonFinite == 0;
  topology = findTopology(mesh, found != nullptr, run);
  const EdgeFaults& faults = topology.adjacency.faults;
  check.shells = topology.shells.count;
  check.openEdges = faults.open;
  check.nonManifoldEdges = faults.nonManifold;
  check.nonManifoldVertices = topology.nonManifoldVertices;
  check.misorientedEdges = faults.misoriented;
  check.unusedVertices = topology.unusedVertices;
  check.closed = faults.odd == 0 && check.triangles > 0;
  check.manifold = check.nonManifoldEdges == 0 && check.nonManifoldVertices == 0;
  if (!check.finite || mesh.triangles.empty()) return check;

  const Sums sums = measure(mesh, mesh.vertices[mesh.triangles[0][0]], run);
  check.volume = sums.volume;
  check.area = sums.area;
  check.degenerateTriangles = sums.degenerate;
  check.oriented =
      check.misorientedEdges == 0 && check.closed && shellsInsideOut(mesh, topology, run).empty();
  if (found == nullptr) return check;

  *found = findSelfIntersections(mesh, topology.entangled, run);
  check.selfIntersections = found->count;
  for (const auto& pair : found->pairs) {
    if (check.firstIntersections.size() == 32) break;
    check.firstIntersections.emplace_back(pair.first, pair.second);
  }
  return check;
}

}  // namespace

MeshCheck checkMesh(const TriMesh& mesh, bool withSelfIntersections, RunContext& run) {
  SelfIntersections found;
  SelfIntersections* wanted = withSelfIntersections ? &found : nullptr;
  MeshTopology topology;
  if (!run.threads) return checkInArena(mesh, topology, wanted, run);
  tbb::task_arena arena(threadsOf(run));
  return arena.execute([&] { return checkInArena(mesh, topology, wanted, run); });
}

MeshCheck checkMesh(const TriMesh& mesh, SelfIntersections& found, RunContext& run) {
  MeshTopology topology;
  return checkInArena(mesh, topology, &found, run);
}

MeshCheck checkMesh(const TriMesh& mesh, MeshTopology& topology, RunContext& run) {
  return checkInArena(mesh, topology, nullptr, run);
}

MeshCheck checkMesh(const TriMesh& mesh, RunContext& run) { return checkMesh(mesh, true, run); }

std::vector<InsideOutShell> shellsInsideOut(const TriMesh& mesh, const MeshTopology& topology,
                                            RunContext& run) {
  const std::vector<ShellExtent> shells = measureShells(mesh, topology.shells);
  run.checkpoint(Phase::Check);
  const std::vector<std::uint8_t> cavity = findCavities(mesh, topology.shells, shells, run);
  std::vector<InsideOutShell> found;
  for (std::size_t s = 0; s < shells.size(); ++s) {
    if (cavity[s] != 0 ? shells[s].volume < 0 : shells[s].volume > 0) continue;
    found.push_back({static_cast<std::int32_t>(s), shells[s].box.diagonal().norm()});
  }
  return found;
}

}  // namespace swept
