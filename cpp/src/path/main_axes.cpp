// SPDX-License-Identifier: LGPL-2.1-or-later
#include "path/main_axes.h"

#include <algorithm>
#include <cmath>

#include "geometry/mesh_parts.h"

namespace swept::path {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kMaxSamples = 20000;  // largest number of triangles that are sampled
constexpr std::size_t kMaxDirections = 256;
constexpr double kSame = 0.9998;  // cosine of about one degree; nearer directions count as the same

struct Direction {
  Vector3d sum;  ///< sum of normals times areas, all turned to the same side
  double area = 0;
};

// Returns the directions of the sampled triangles, each with the area that faces it, largest area
// first.
std::vector<Direction> directionsOf(const std::vector<const TriMesh*>& meshes) {
  std::size_t triangles = 0;
  for (const TriMesh* mesh : meshes) triangles += mesh->triangles.size();
  const std::size_t step = triangles / kMaxSamples + 1;
  std::vector<Direction> list;
  std::size_t counted = 0;
  for (const TriMesh* mesh : meshes) {
    const auto count = static_cast<std::int64_t>(mesh->vertices.size());
    for (const auto& t : mesh->triangles) {
      if (counted++ % step != 0) continue;
      if (std::any_of(t.begin(), t.end(), [&](std::int32_t v) { return v < 0 || v >= count; }))
        continue;  // invalid index; an error is reported when the mesh becomes a Part
      const Vector3d n = areaVector(*mesh, t);
      const double area = n.norm();
      if (!(area > 0) || !std::isfinite(area)) continue;
      const auto same = std::find_if(list.begin(), list.end(), [&](const Direction& d) {
        return std::abs(d.sum.dot(n)) >= kSame * d.area * area;
      });
      if (same != list.end()) {
        same->sum += same->sum.dot(n) < 0 ? Vector3d(-n) : n;
        same->area += area;
      } else if (list.size() < kMaxDirections) {
        list.push_back({n, area});
      }
    }
  }
  std::stable_sort(list.begin(), list.end(),
                   [](const Direction& a, const Direction& b) { return a.area > b.area; });
  return list;
}

}  // namespace

Eigen::Matrix3d mainAxes(const std::vector<const TriMesh*>& meshes) {
  const std::vector<Direction> list = directionsOf(meshes);
  if (list.empty()) return Eigen::Matrix3d::Identity();
  Eigen::Matrix3d axes;
  axes.col(0) = list.front().sum.normalized();
  const auto second = std::find_if(list.begin(), list.end(), [&](const Direction& d) {
    return std::abs(d.sum.normalized().dot(axes.col(0))) < 0.05;
  });
  const Vector3d other =
      second != list.end() ? Vector3d(second->sum) : Vector3d(axes.col(0).unitOrthogonal());
  axes.col(1) = (other - axes.col(0) * axes.col(0).dot(other)).normalized();
  axes.col(2) = axes.col(0).cross(axes.col(1));
  return axes;
}

TriMesh turnedMesh(const TriMesh& mesh, const Eigen::Matrix3d& rotation) {
  TriMesh out = mesh;
  for (Vector3d& x : out.vertices) x = rotation * x;
  return out;
}

}  // namespace swept::path
