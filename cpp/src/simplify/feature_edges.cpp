// SPDX-License-Identifier: LGPL-2.1-or-later
#include "simplify/feature_edges.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "base/edge_table.h"
#include "base/parallel.h"
#include "simplify/quadric.h"

namespace swept {
namespace {

constexpr double kRankCut = 0.03;  ///< of the largest eigenvalue
constexpr double kCosine = 0.906;  ///< of 25 degrees, the least turn of a crease

std::vector<std::uint8_t> onFeature(const TriMesh& mesh,
                                    const std::vector<Eigen::Vector3d>& normals) {
  std::vector<Quadric> quadrics(mesh.vertices.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const double area = normals[t].norm();
    if (!(area > 0)) continue;
    // Only the directions count: planes through the origin.
    for (const std::int32_t v : mesh.triangles[t]) {
      quadrics[v].addPlane(normals[t] / area, Eigen::Vector3d::Zero(), area);
    }
  }
  std::vector<std::uint8_t> feature(mesh.vertices.size());
  parallelBlocks(feature.size(), 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      int rank = 0;
      quadrics[v].minimise(Eigen::Vector3d::Zero(), kRankCut, rank);
      feature[v] = rank > 1;
    }
  });
  return feature;
}

}  // namespace

std::vector<std::array<std::int32_t, 2>> findFeatureEdges(const TriMesh& mesh) {
  const std::size_t n = mesh.triangles.size();
  std::vector<Eigen::Vector3d> normals(n);
  parallelBlocks(n, 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      const auto& c = mesh.triangles[t];
      const Eigen::Vector3d u = mesh.vertices[c[1]] - mesh.vertices[c[0]];
      const Eigen::Vector3d v = mesh.vertices[c[2]] - mesh.vertices[c[0]];
      normals[t] = u.cross(v);
    }
  });
  const std::vector<std::uint8_t> feature = onFeature(mesh, normals);
  const EdgeTable table(mesh.triangles, static_cast<std::int64_t>(mesh.vertices.size()));
  constexpr std::size_t kBlock = 8192;
  std::vector<std::vector<std::array<std::int32_t, 2>>> parts(mesh.vertices.size() / kBlock + 1);
  parallelBlocks(mesh.vertices.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    table.forEachEdge(static_cast<std::int64_t>(begin), static_cast<std::int64_t>(end),
                      [&](std::int32_t low, std::int32_t high, const std::uint64_t* first,
                          const std::uint64_t* last) {
                        if (last - first != 2 || !feature[low] || !feature[high]) return;
                        const auto& m = normals[EdgeTable::halfEdge(first[0]) / 3];
                        const auto& k = normals[EdgeTable::halfEdge(first[1]) / 3];
                        if (m.dot(k) < kCosine * m.norm() * k.norm()) {
                          parts[begin / kBlock].push_back({low, high});
                        }
                      });
  });
  std::vector<std::array<std::int32_t, 2>> edges;
  for (const auto& part : parts) edges.insert(edges.end(), part.begin(), part.end());
  return edges;
}

}  // namespace swept
