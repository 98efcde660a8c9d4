// SPDX-License-Identifier: LGPL-2.1-or-later
#include "check/mesh_check.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <string>
#include <unordered_map>

#include "base/threads.h"
#include "check/mesh_topology.h"
#include "check/self_intersections.h"
#include "geometry/exact_predicates.h"
#include "geometry/ray_columns.h"
#include "swept/compute.h"

namespace swept {
namespace {

constexpr std::size_t kBlock = 1 << 14;
using Range = tbb::blocked_range<std::size_t>;

void requireValidIndices(const TriMesh& mesh) {
  const auto count = static_cast<std::int64_t>(mesh.vertices.size());
  std::atomic<bool> valid{true};
  tbb::parallel_for(Range(0, mesh.triangles.size(), kBlock), [&](const Range& range) {
    for (std::size_t t = range.begin(); t != range.end(); ++t) {
      const auto& tri = mesh.triangles[t];
      if (std::min({tri[0], tri[1], tri[2]}) < 0 || std::max({tri[0], tri[1], tri[2]}) >= count) {
        valid.store(false, std::memory_order_relaxed);
      }
    }
  });
  for (std::size_t t = 0; !valid && t < mesh.triangles.size(); ++t) {
    for (const std::int32_t v : mesh.triangles[t]) {
      if (v >= 0 && v < count) continue;
      throw Error(Status::InvalidInput, "BadIndex",
                  "triangle " + std::to_string(t) + " refers to vertex " + std::to_string(v) +
                      "; the mesh has " + std::to_string(count) + " vertices");
    }
  }
}

bool allFinite(const TriMesh& mesh) {
  std::atomic<bool> finite{true};
  tbb::parallel_for(Range(0, mesh.vertices.size(), kBlock), [&](const Range& range) {
    bool here = true;
    for (std::size_t v = range.begin(); v != range.end(); ++v) {
      here = here && mesh.vertices[v].allFinite();
    }
    if (!here) finite.store(false, std::memory_order_relaxed);
  });
  return finite;
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
  std::int32_t first = -1, last = -1;  ///< triangles

  void add(const Shell& other) {
    volume += other.volume;
    low = low.cwiseMin(other.low);
    high = high.cwiseMax(other.high);
    if (first < 0) first = other.first;
    last = other.last;
  }
};

/// The shells within one block of triangles, in the order in which they appear.
using ShellParts = std::vector<std::pair<std::int32_t, Shell>>;

ShellParts measureBlock(const TriMesh& mesh, const MeshTopology& topology,
                        const std::vector<Eigen::Vector3d>& origins, std::size_t begin,
                        std::size_t end) {
  ShellParts parts;
  std::unordered_map<std::int32_t, std::size_t> places;
  std::size_t place = 0;
  for (std::size_t t = begin; t < end; ++t) {
    const std::int32_t s = topology.shellOf[t];
    if (parts.empty() || parts[place].first != s) {
      const auto [it, fresh] = places.try_emplace(s, parts.size());
      if (fresh) parts.emplace_back(s, Shell{});
      place = it->second;
    }
    Shell& shell = parts[place].second;
    if (shell.first < 0) shell.first = static_cast<std::int32_t>(t);
    shell.last = static_cast<std::int32_t>(t);
    const auto& tri = mesh.triangles[t];
    const auto &a = mesh.vertices[tri[0]], &b = mesh.vertices[tri[1]], &c = mesh.vertices[tri[2]];
    shell.volume += (a - origins[s]).dot((b - a).cross(c - a)) / 6;
    shell.low = shell.low.cwiseMin(a).cwiseMin(b).cwiseMin(c);
    shell.high = shell.high.cwiseMax(a).cwiseMax(b).cwiseMax(c);
  }
  return parts;
}

std::vector<Shell> measureShells(const TriMesh& mesh, const MeshTopology& topology) {
  // Volume as seen from a vertex of the shell itself, so that a far-off place costs no digits.
  std::vector<Eigen::Vector3d> origins;
  for (std::size_t t = 0; static_cast<std::int64_t>(origins.size()) < topology.shells; ++t) {
    if (topology.shellOf[t] == static_cast<std::int32_t>(origins.size())) {
      origins.push_back(mesh.vertices[mesh.triangles[t][0]]);
    }
  }
  std::vector<ShellParts> blocks((mesh.triangles.size() + kBlock - 1) / kBlock);
  tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t i) {
    blocks[i] = measureBlock(mesh, topology, origins, i * kBlock,
                             std::min(mesh.triangles.size(), (i + 1) * kBlock));
  });
  std::vector<Shell> shells(static_cast<std::size_t>(topology.shells));
  for (const ShellParts& parts : blocks) {
    for (const auto& [s, shell] : parts) shells[s].add(shell);
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

/// Shells whose box lies within that of another one.
std::vector<std::int32_t> nestedShells(const std::vector<Shell>& shells, RunContext& run) {
  std::vector<std::int32_t> byLow(shells.size());
  for (std::size_t i = 0; i < shells.size(); ++i) byLow[i] = static_cast<std::int32_t>(i);
  std::sort(byLow.begin(), byLow.end(),
            [&](std::int32_t a, std::int32_t b) { return shells[a].low.x() < shells[b].low.x(); });
  std::vector<std::uint8_t> nested(shells.size(), 0);
  for (std::size_t i = 0; i < byLow.size(); ++i) {
    if (i % 256 == 0) run.checkpoint(Phase::Check);
    for (std::size_t j = i + 1; j < byLow.size(); ++j) {
      if (shells[byLow[j]].low.x() >= shells[byLow[i]].high.x()) break;
      if (boxInside(shells[byLow[j]], shells[byLow[i]])) nested[byLow[j]] = 1;
    }
  }
  std::vector<std::int32_t> result;
  for (std::size_t s = 0; s < shells.size(); ++s) {
    if (nested[s] != 0) result.push_back(static_cast<std::int32_t>(s));
  }
  return result;
}

/// Shells that lie in an even number of others bound material from outside, the rest a cavity.
std::vector<std::uint8_t> findCavities(const TriMesh& mesh, const MeshTopology& topology,
                                       const std::vector<Shell>& shells, RunContext& run) {
  const std::vector<std::int32_t> nested = nestedShells(shells, run);
  std::vector<std::uint8_t> cavity(shells.size(), 0);
  if (!nested.empty()) {
    Shell region;
    for (const std::int32_t s : nested) region.add(shells[s]);
    const RayColumns columns(mesh, region.low, region.high);
    for (const std::int32_t s : nested) {
      run.checkpoint(Phase::Check);
      // Shells that cross each other have no depth of their own: two samples that agree, or the
      // outward rule.
      const int depth = depthOf(mesh, topology, shells, columns, shells[s].first);
      const bool sure = depth == depthOf(mesh, topology, shells, columns, shells[s].last);
      cavity[s] = sure && depth % 2 == 1;
    }
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
  check.finite = allFinite(mesh);
  check.selfIntersections = -1;
  topology = findTopology(mesh, found != nullptr, run);
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
  if (run.threads == 0) return checkInArena(mesh, topology, wanted, run);
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
  const std::vector<Shell> shells = measureShells(mesh, topology);
  run.checkpoint(Phase::Check);
  const std::vector<std::uint8_t> cavity = findCavities(mesh, topology, shells, run);
  std::vector<InsideOutShell> found;
  for (std::size_t s = 0; s < shells.size(); ++s) {
    const Shell& shell = shells[s];
    if (cavity[s] != 0 ? shell.volume < 0 : shell.volume > 0) continue;
    found.push_back({static_cast<std::int32_t>(s), (shell.high - shell.low).norm()});
  }
  return found;
}

}  // namespace swept
