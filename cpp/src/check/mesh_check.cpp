// SPDX-License-Identifier: LGPL-2.1-or-later
#include "check/mesh_check.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "base/exact_predicates.h"
#include "base/ray_columns.h"
#include "check/mesh_topology.h"
#include "check/self_intersections.h"
#include "swept/compute.h"

namespace swept {
namespace {

constexpr std::size_t kBlock = 1 << 14;

void requireValidIndices(const TriMesh& mesh) {
  const auto count = static_cast<std::int64_t>(mesh.vertices.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const std::int32_t v : mesh.triangles[t]) {
      if (v >= 0 && v < count) continue;
      throw Error(Status::InvalidInput, "BadIndex",
                  "triangle " + std::to_string(t) + " refers to vertex " + std::to_string(v) +
                      "; the mesh has " + std::to_string(count) + " vertices");
    }
  }
}

bool allFinite(const TriMesh& mesh) {
  return std::all_of(mesh.vertices.begin(), mesh.vertices.end(),
                     [](const Eigen::Vector3d& v) { return v.allFinite(); });
}

struct Sums {
  double volume = 0, area = 0;
  std::int64_t degenerate = 0;
};

/// Sums over blocks of fixed size, added in order: the same digits for any number of threads.
Sums measure(const TriMesh& mesh, const Eigen::Vector3d& origin, RunContext& run) {
  std::vector<Sums> parts((mesh.triangles.size() + kBlock - 1) / kBlock);
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t part) {
    run.checkpoint(Phase::Check);
    Sums sums;
    const std::size_t end = std::min(mesh.triangles.size(), (part + 1) * kBlock);
    for (std::size_t t = part * kBlock; t < end; ++t) {
      const auto& tri = mesh.triangles[t];
      const Eigen::Vector3d a = mesh.vertices[tri[0]] - origin;
      const Eigen::Vector3d u = mesh.vertices[tri[1]] - mesh.vertices[tri[0]];
      const Eigen::Vector3d v = mesh.vertices[tri[2]] - mesh.vertices[tri[0]];
      const Eigen::Vector3d n = u.cross(v);
      sums.volume += a.dot(n) / 6;
      const double twice = n.norm();
      sums.area += twice / 2;
      // Far above rounding: has area. Else the exact answer counts.
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

struct Shell {
  double volume = 0;
  Eigen::Vector3d low = Eigen::Vector3d::Constant(HUGE_VAL);
  Eigen::Vector3d high = Eigen::Vector3d::Constant(-HUGE_VAL);
  std::int64_t size = 0;
  std::int32_t first = -1, last = -1;
};

std::vector<Shell> measureShells(const TriMesh& mesh, const MeshTopology& topology) {
  std::vector<Shell> shells(topology.shells);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    Shell& shell = shells[topology.shellOf[t]];
    const auto& tri = mesh.triangles[t];
    if (shell.first < 0) shell.first = static_cast<std::int32_t>(t);
    shell.last = static_cast<std::int32_t>(t);
    ++shell.size;
    // Volume as seen from a vertex of the shell itself, so that a far-off place costs no digits.
    const Eigen::Vector3d& origin = mesh.vertices[mesh.triangles[shell.first][0]];
    const Eigen::Vector3d a = mesh.vertices[tri[0]] - origin;
    const Eigen::Vector3d b = mesh.vertices[tri[1]] - origin;
    const Eigen::Vector3d c = mesh.vertices[tri[2]] - origin;
    shell.volume += a.dot(b.cross(c)) / 6;
    for (const std::int32_t v : tri) {
      shell.low = shell.low.cwiseMin(mesh.vertices[v]);
      shell.high = shell.high.cwiseMax(mesh.vertices[v]);
    }
  }
  return shells;
}

bool boxInside(const Shell& inner, const Shell& outer) {
  return (inner.low.array() > outer.low.array()).all() &&
         (inner.high.array() < outer.high.array()).all();
}

/// Number of shells that hold a point of triangle t of the shell `inner`.
int depthOf(const TriMesh& mesh, const MeshTopology& topology, const std::vector<Shell>& shells,
            const RayColumns& columns, std::int32_t t) {
  const auto& tri = mesh.triangles[t];
  // Odd weights: a point in general position on the triangle.
  const Eigen::Vector3d p = 0.3137 * mesh.vertices[tri[0]] + 0.2731 * mesh.vertices[tri[1]] +
                            0.4132 * mesh.vertices[tri[2]];
  std::vector<RayColumns::Crossing> line;
  columns.crossings(p.y(), p.z(), line);
  const Shell& inner = shells[topology.shellOf[t]];
  std::vector<std::int32_t> odd;
  for (const auto& crossing : line) {
    const std::int32_t s = topology.shellOf[crossing.triangle];
    if (crossing.x <= p.x() || !boxInside(inner, shells[s])) continue;
    const auto it = std::find(odd.begin(), odd.end(), s);
    it == odd.end() ? odd.push_back(s) : static_cast<void>(odd.erase(it));
  }
  return static_cast<int>(odd.size());
}

/// Shells that lie in an even number of others bound material from outside, the rest a cavity.
bool shellsOriented(const TriMesh& mesh, const MeshTopology& topology, RunContext& run) {
  const std::vector<Shell> shells = measureShells(mesh, topology);
  run.checkpoint(Phase::Check);
  // Only shells that turn inward can lie wrongly, or those that another one might hold.
  bool nested = false;
  if (shells.size() > 1) {
    std::vector<std::int32_t> byLow(shells.size());
    for (std::size_t i = 0; i < shells.size(); ++i) byLow[i] = static_cast<std::int32_t>(i);
    std::sort(byLow.begin(), byLow.end(), [&](std::int32_t a, std::int32_t b) {
      return shells[a].low.x() < shells[b].low.x();
    });
    for (std::size_t i = 0; i < byLow.size() && !nested; ++i) {
      for (std::size_t j = i + 1; j < byLow.size() && !nested; ++j) {
        if (shells[byLow[j]].low.x() >= shells[byLow[i]].high.x()) break;
        nested = boxInside(shells[byLow[j]], shells[byLow[i]]);
      }
    }
  }
  if (!nested) {
    return std::all_of(shells.begin(), shells.end(), [](const Shell& s) { return s.volume > 0; });
  }
  const RayColumns columns(mesh);
  for (const Shell& shell : shells) {
    run.checkpoint(Phase::Check);
    // Shells that cross each other have no depth of their own: two samples that agree, or the
    // outward rule.
    const int depth = depthOf(mesh, topology, shells, columns, shell.first);
    const bool sure = depth == depthOf(mesh, topology, shells, columns, shell.last);
    const bool cavity = sure && depth % 2 == 1;
    if (cavity ? !(shell.volume < 0) : !(shell.volume > 0)) return false;
  }
  return true;
}

MeshCheck checkInArena(const TriMesh& mesh, SelfIntersections* found, RunContext& run) {
  run.checkpoint(Phase::Check);
  MeshCheck check;
  check.vertices = static_cast<std::int64_t>(mesh.vertices.size());
  check.triangles = static_cast<std::int64_t>(mesh.triangles.size());
  requireValidIndices(mesh);
  check.finite = allFinite(mesh);
  check.selfIntersections = -1;
  const MeshTopology topology = findTopology(mesh, run);
  check.shells = topology.shells;
  check.openEdges = topology.openEdges;
  check.nonManifoldEdges = topology.nonManifoldEdges;
  check.nonManifoldVertices = topology.nonManifoldVertices;
  check.misorientedEdges = topology.misorientedEdges;
  check.unusedVertices = topology.unusedVertices;
  check.closed = topology.oddEdges == 0 && check.triangles > 0;
  check.manifold = check.nonManifoldEdges == 0 && check.nonManifoldVertices == 0;
  if (!check.finite || mesh.triangles.empty()) return check;

  const Sums sums = measure(mesh, mesh.vertices[mesh.triangles[0][0]], run);
  check.volume = sums.volume;
  check.area = sums.area;
  check.degenerateTriangles = sums.degenerate;
  check.oriented =
      check.misorientedEdges == 0 && check.closed && shellsOriented(mesh, topology, run);
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
  if (run.threads <= 0) return checkInArena(mesh, wanted, run);
  tbb::task_arena arena(run.threads);
  return arena.execute([&] { return checkInArena(mesh, wanted, run); });
}

MeshCheck checkMesh(const TriMesh& mesh, SelfIntersections& found, RunContext& run) {
  return checkInArena(mesh, &found, run);
}

MeshCheck checkMesh(const TriMesh& mesh, RunContext& run) { return checkMesh(mesh, true, run); }

}  // namespace swept
