// SPDX-License-Identifier: LGPL-2.1-or-later
#include "simplify/feature_edges.h"

#include <tbb/parallel_sort.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "base/lists_by_key.h"
#include "base/parallel.h"
#include "geometry/half_edges.h"
#include "geometry/quadric.h"

namespace swept {
namespace {

/// Eigenvalues below this fraction of the largest one count as 0.
constexpr double kRankCut = 0.03;
constexpr double kCosine = 0.906;  ///< cosine of 25 degrees, the smallest angle of a crease
constexpr std::size_t kEdgeBlock = 8192;
constexpr std::uint32_t kNone = 0xffffffffu;
using Edge = std::array<std::int32_t, 2>;

Eigen::Vector3d normalOf(const TriMesh& mesh, std::size_t t) {
  const auto& c = mesh.triangles[t];
  const Eigen::Vector3d u = mesh.vertices[c[1]] - mesh.vertices[c[0]];
  const Eigen::Vector3d v = mesh.vertices[c[2]] - mesh.vertices[c[0]];
  return u.cross(v);
}

/// Returns the edges with two triangles at which the surface turns by more than the angle of a
/// crease.
std::vector<Edge> turningEdges(const TriMesh& mesh, const RawArray<std::uint32_t>& across) {
  const std::size_t n = mesh.triangles.size();
  std::vector<std::vector<Edge>> parts(n / kEdgeBlock + 1);
  parallelBlocks(n, kEdgeBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      const Eigen::Vector3d normal = normalOf(mesh, t);
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t other = across[3 * t + k];
        if (other == kNoNeighbour || other < 3 * t + k) continue;
        const Eigen::Vector3d otherNormal = normalOf(mesh, other / 3);
        const double dot = normal.dot(otherNormal);
        if (dot > 0 &&
            dot * dot >= kCosine * kCosine * normal.squaredNorm() * otherNormal.squaredNorm()) {
          continue;
        }
        const std::int32_t a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
        parts[begin / kEdgeBlock].push_back({std::min(a, b), std::max(a, b)});
      }
    }
  });
  std::vector<Edge> edges;
  for (const auto& part : parts) edges.insert(edges.end(), part.begin(), part.end());
  tbb::parallel_sort(edges.begin(), edges.end());
  return edges;
}

/// Returns for each vertex whether it belongs to one of the edges and the planes of its triangles
/// have rank 2 or 3.
std::vector<std::uint8_t> onFeature(const TriMesh& mesh, const std::vector<Edge>& edges) {
  std::vector<std::uint32_t> indexOf(mesh.vertices.size(), kNone);
  std::vector<std::int32_t> vertices;
  for (const Edge& edge : edges) {
    for (const std::int32_t v : edge) {
      if (indexOf[v] != kNone) continue;
      indexOf[v] = static_cast<std::uint32_t>(vertices.size());
      vertices.push_back(v);
    }
  }
  ListsByKey around(vertices.size(), [&](const auto& use) {
    parallelBlocks(mesh.triangles.size(), kEdgeBlock, [&](std::size_t begin, std::size_t end) {
      for (std::size_t t = begin; t < end; ++t) {
        for (const std::int32_t v : mesh.triangles[t]) {
          if (indexOf[v] != kNone) use(indexOf[v], static_cast<std::uint32_t>(t));
        }
      }
    });
  });
  std::vector<std::uint8_t> feature(mesh.vertices.size());
  parallelBlocks(vertices.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      Quadric quadric;
      for (const std::uint32_t t : around.of(n)) {
        const Eigen::Vector3d normal = normalOf(mesh, t);
        const double area = normal.norm();
        // Only the directions matter, so all planes pass through the origin.
        if (area > 0) quadric.addPlane(normal / area, Eigen::Vector3d::Zero(), area);
      }
      int rank = 0;
      quadric.minimise(Eigen::Vector3d::Zero(), kRankCut, rank);
      feature[vertices[n]] = rank > 1;
    }
  });
  return feature;
}

}  // namespace

std::vector<Edge> findFeatureEdges(const TriMesh& mesh, const RawArray<std::uint32_t>& across) {
  std::vector<Edge> edges = turningEdges(mesh, across);
  const std::vector<std::uint8_t> feature = onFeature(mesh, edges);
  std::erase_if(edges, [&](const Edge& e) { return !feature[e[0]] || !feature[e[1]]; });
  return edges;
}

std::vector<Edge> findFeatureEdges(const TriMesh& mesh) {
  return findFeatureEdges(mesh, findAdjacency(mesh).across);
}

}  // namespace swept
