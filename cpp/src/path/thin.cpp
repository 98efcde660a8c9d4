// SPDX-License-Identifier: LGPL-2.1-or-later
#include "path/thin.h"

#include <Eigen/Dense>
#include <algorithm>

#include "base/parallel.h"
#include "input/body_weld.h"

namespace swept::path {
namespace {

using Eigen::Vector3d;

constexpr double kLongest = 2;  // skins that a vertex of a sharp edge may move

// The shift by which a vertex gets one unit behind each plane that meets in it.
Vector3d inward(const std::vector<Vector3d>& normals) {
  Eigen::Matrix3d planes = 1e-3 * Eigen::Matrix3d::Identity();
  Vector3d sum = Vector3d::Zero();
  for (const Vector3d& n : normals) {
    planes += n * n.transpose();
    sum -= n;
  }
  const Vector3d shift = planes.ldlt().solve(sum);
  const double length = shift.norm();
  return length > kLongest ? Vector3d(shift * (kLongest / length)) : shift;
}

}  // namespace

TriMesh thinned(const clearance::Part& part, double skin) {
  TriMesh mesh;
  for (std::uint32_t place = 0; place < part.tree().size(); ++place) {
    const auto first = static_cast<std::int32_t>(mesh.vertices.size());
    for (const Vector3d& x : part.corners(place)) mesh.vertices.push_back(x);
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  applyMap(exactWeld(mesh.vertices), mesh);
  if (!part.closed()) return mesh;
  std::vector<std::vector<Vector3d>> normals(mesh.vertices.size());
  for (const auto& t : mesh.triangles) {
    const Vector3d n = (mesh.vertices[t[1]] - mesh.vertices[t[0]])
                           .cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]);
    const double size = n.norm();
    if (!(size > 0)) continue;
    const Vector3d unit = n / size;
    for (const std::int32_t v : t) {
      auto& list = normals[v];
      const bool seen = std::any_of(list.begin(), list.end(),
                                    [&](const Vector3d& m) { return m.dot(unit) > 0.999; });
      if (!seen && list.size() < 16) list.push_back(unit);
    }
  }
  TriMesh thin = mesh;
  parallelBlocks(mesh.vertices.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (normals[i].empty()) continue;
      const Vector3d shift = inward(normals[i]);
      for (double depth = skin; depth > 0.05 * skin; depth *= 0.5) {
        // Half as deep at least, or the other side is near.
        const Vector3d moved = mesh.vertices[i] + depth * shift;
        if (part.depth(moved) < 0.5 * depth) continue;
        thin.vertices[i] = moved;
        break;
      }
    }
  });
  return thin;
}

}  // namespace swept::path
