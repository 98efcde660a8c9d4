// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/mesh/half_edge.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "base/limits.h"
#include "base/parallel.h"

namespace swept::step {
namespace {

[[noreturn]] void refuse(const char* code, const std::string& what) {
  throw Error(Status::ExportFailed, code,
              what +
                  "; a solid needs a closed, oriented, edge-manifold mesh: run the mesh check "
                  "and repair the mesh, or export it as a mesh file");
}

void checkNumbers(const TriMesh& mesh) {
  if (mesh.triangles.empty()) refuse("EmptyMesh", "the mesh has no triangles");
  const auto count = static_cast<std::int64_t>(mesh.vertices.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const std::int64_t v = mesh.triangles[t][k];
      if (v < 0 || v >= count) {
        refuse("BadIndex", "triangle " + std::to_string(t) + " uses vertex " + std::to_string(v) +
                               " of " + std::to_string(count));
      }
      if (!mesh.vertices[v].allFinite()) {
        refuse("NonFiniteVertex", "vertex " + std::to_string(v) + " is not finite");
      }
      if (mesh.vertices[v].cwiseAbs().maxCoeff() > kLargestLength) {
        throw Error(Status::ExportFailed, "OutOfRange",
                    "vertex " + std::to_string(v) +
                        " lies more than 1e9 mm from the origin; move the mesh nearer, or check "
                        "its unit");
      }
      if (v == mesh.triangles[t][(k + 1) % 3]) {
        refuse("DegenerateTriangle", "triangle " + std::to_string(t) + " repeats a vertex");
      }
    }
  }
}

struct EdgeKey {
  std::int32_t low, high, halfEdge;
};

void pairHalfEdges(HalfEdgeMesh& mesh, RunContext& run) {
  const auto count = static_cast<std::int32_t>(3 * mesh.triangles.size());
  // Sorted by their lower vertex by counting, then the few of each vertex.
  std::vector<std::int32_t> start(mesh.points.size() + 1, 0);
  for (std::int32_t h = 0; h < count; ++h) ++start[std::min(mesh.origin(h), mesh.target(h))];
  exclusiveScan(start);
  std::vector<EdgeKey> keys(count);
  {
    std::vector<std::int32_t> at(start.begin(), start.end() - 1);
    for (std::int32_t h = 0; h < count; ++h) {
      const auto [low, high] = std::minmax({mesh.origin(h), mesh.target(h)});
      keys[at[low]++] = {low, high, h};
    }
  }
  parallelBlocks(mesh.points.size(), 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      std::sort(keys.begin() + start[v], keys.begin() + start[v + 1],
                [](const EdgeKey& a, const EdgeKey& b) {
                  return std::tie(a.high, a.halfEdge) < std::tie(b.high, b.halfEdge);
                });
    }
  });
  run.checkpoint(Phase::Export);
  mesh.opposite.assign(count, -1);
  std::int64_t open = 0, crowded = 0, turned = 0;
  for (std::size_t i = 0; i < keys.size();) {
    std::size_t j = i;
    while (j < keys.size() && keys[j].low == keys[i].low && keys[j].high == keys[i].high) ++j;
    if (j - i == 1) {
      ++open;
    } else if (j - i > 2) {
      ++crowded;
    } else if (mesh.origin(keys[i].halfEdge) == mesh.origin(keys[i + 1].halfEdge)) {
      ++turned;
    } else {
      mesh.opposite[keys[i].halfEdge] = keys[i + 1].halfEdge;
      mesh.opposite[keys[i + 1].halfEdge] = keys[i].halfEdge;
    }
    i = j;
  }
  if (open > 0) refuse("OpenMesh", std::to_string(open) + " edges have one triangle only");
  if (crowded > 0)
    refuse("NonManifold", std::to_string(crowded) + " edges have more than two triangles");
  if (turned > 0) {
    refuse("MixedOrientation",
           std::to_string(turned) + " edges have triangles that disagree in orientation");
  }
}

// One vertex per fan of triangles; corners around a vertex are reached through opposite half-edges.
void splitFans(HalfEdgeMesh& mesh) {
  const auto count = static_cast<std::int32_t>(3 * mesh.triangles.size());
  std::vector<char> seen(count, 0), used(mesh.points.size(), 0);
  for (std::int32_t first = 0; first < count; ++first) {
    if (seen[first]) continue;
    std::int32_t vertex = mesh.origin(first);
    if (used[vertex]) {
      mesh.points.push_back(mesh.points[vertex]);
      used.push_back(1);
      vertex = static_cast<std::int32_t>(mesh.points.size()) - 1;
    }
    used[vertex] = 1;
    std::int32_t h = first;
    do {
      seen[h] = 1;
      mesh.triangles[h / 3][h % 3] = vertex;
      h = mesh.opposite[HalfEdgeMesh::previous(h)];
    } while (h != first);
  }
}

void findShells(HalfEdgeMesh& mesh) {
  const std::size_t count = mesh.triangles.size();
  mesh.shellOf.assign(count, -1);
  std::vector<std::int32_t> stack;
  for (std::size_t seed = 0; seed < count; ++seed) {
    if (mesh.shellOf[seed] >= 0) continue;
    const auto shell = static_cast<std::int32_t>(mesh.shellVolume.size());
    // Relative to a point of the shell, or volumes of small shells far from the origin lose digits.
    const Eigen::Vector3d base = mesh.points[mesh.triangles[seed][0]];
    double volume = 0;
    stack.assign(1, static_cast<std::int32_t>(seed));
    mesh.shellOf[seed] = shell;
    while (!stack.empty()) {
      const std::int32_t t = stack.back();
      stack.pop_back();
      const auto& tri = mesh.triangles[t];
      volume += (mesh.points[tri[0]] - base)
                    .dot((mesh.points[tri[1]] - base).cross(mesh.points[tri[2]] - base)) /
                6.0;
      for (int k = 0; k < 3; ++k) {
        const std::int32_t other = mesh.opposite[3 * t + k] / 3;
        if (mesh.shellOf[other] >= 0) continue;
        mesh.shellOf[other] = shell;
        stack.push_back(other);
      }
    }
    mesh.shellVolume.push_back(volume);
  }
}

// Winding number of one shell about a point, by solid angles.
double winding(const HalfEdgeMesh& mesh, const std::vector<std::int32_t>& triangles,
               const Eigen::Vector3d& point) {
  double angle = 0;
  for (const std::int32_t t : triangles) {
    const Eigen::Vector3d a = mesh.points[mesh.triangles[t][0]] - point;
    const Eigen::Vector3d b = mesh.points[mesh.triangles[t][1]] - point;
    const Eigen::Vector3d c = mesh.points[mesh.triangles[t][2]] - point;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    const double det = a.dot(b.cross(c));
    const double den = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
    angle += 2 * std::atan2(det, den);
  }
  return angle / (4 * M_PI);
}

void findOwners(HalfEdgeMesh& mesh, RunContext& run) {
  const auto shells = static_cast<std::int32_t>(mesh.shellVolume.size());
  mesh.shellOwner.resize(shells);
  std::iota(mesh.shellOwner.begin(), mesh.shellOwner.end(), 0);
  if (std::all_of(mesh.shellVolume.begin(), mesh.shellVolume.end(),
                  [](double v) { return v > 0; })) {
    return;
  }
  std::vector<std::vector<std::int32_t>> members(shells);
  std::vector<Eigen::Vector3d> low(shells, Eigen::Vector3d::Constant(1e300));
  std::vector<Eigen::Vector3d> high(shells, Eigen::Vector3d::Constant(-1e300));
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::int32_t s = mesh.shellOf[t];
    members[s].push_back(static_cast<std::int32_t>(t));
    for (const std::int32_t v : mesh.triangles[t]) {
      low[s] = low[s].cwiseMin(mesh.points[v]);
      high[s] = high[s].cwiseMax(mesh.points[v]);
    }
  }
  for (std::int32_t s = 0; s < shells; ++s) {
    if (mesh.shellVolume[s] > 0) continue;
    run.checkpoint(Phase::Export);
    const Eigen::Vector3d point = mesh.points[mesh.triangles[members[s][0]][0]];
    std::int32_t best = -1;
    for (std::int32_t o = 0; o < shells; ++o) {
      if (mesh.shellVolume[o] <= 0) continue;
      if ((low[s] - low[o]).minCoeff() < 0 || (high[o] - high[s]).minCoeff() < 0) continue;
      if (best >= 0 && mesh.shellVolume[o] > mesh.shellVolume[best]) continue;
      if (winding(mesh, members[o], point) > 0.5) best = o;
    }
    if (best < 0) {
      refuse("InvertedShell", "shell " + std::to_string(s) + " with " +
                                  std::to_string(members[s].size()) +
                                  " triangles faces inward and lies in no outer shell");
    }
    mesh.shellOwner[s] = best;
  }
}

}  // namespace

Eigen::Vector3d HalfEdgeMesh::areaVector(std::int32_t triangle) const {
  const auto& t = triangles[triangle];
  return (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]);
}

HalfEdgeMesh buildHalfEdges(const TriMesh& mesh, RunContext& run) {
  run.checkpoint(Phase::Export);
  checkNumbers(mesh);
  HalfEdgeMesh result;
  result.points = mesh.vertices;
  result.triangles = mesh.triangles;
  pairHalfEdges(result, run);
  splitFans(result);
  findShells(result);
  findOwners(result, run);
  for (const double v : result.shellVolume) result.volume += v;
  for (std::size_t t = 0; t < result.triangles.size(); ++t) {
    result.area += 0.5 * result.areaVector(static_cast<std::int32_t>(t)).norm();
  }
  return result;
}

}  // namespace swept::step
