// The box of a mesh, the area vector of a triangle, and copies of triangles.
//
// Units: those of the mesh. Cost: O(1) per triangle; O(vertices) for the box.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <vector>

#include "swept/types.h"

namespace swept {

inline Eigen::AlignedBox3d boxOf(const TriMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : mesh.vertices) box.extend(p);
  return box;
}

/// Returns the normal of a triangle, with twice the area as its length.
inline Eigen::Vector3d areaVector(const TriMesh& mesh,
                                  const std::array<std::int32_t, 3>& triangle) {
  const Eigen::Vector3d& a = mesh.vertices[triangle[0]];
  return (mesh.vertices[triangle[1]] - a).cross(mesh.vertices[triangle[2]] - a);
}

/// Appends a triangle of `from` to `mesh`, and those of its vertices that `mesh` lacks. `number`:
/// for each vertex of `from`, its index in `mesh`, or -1 if `mesh` lacks it; the function updates
/// `number`.
inline void takeTriangle(const TriMesh& from, std::size_t triangle,
                         std::vector<std::int32_t>& number, TriMesh& mesh) {
  std::array<std::int32_t, 3> corners = from.triangles[triangle];
  for (std::int32_t& corner : corners) {
    if (number[corner] < 0) {
      number[corner] = static_cast<std::int32_t>(mesh.vertices.size());
      mesh.vertices.push_back(from.vertices[corner]);
    }
    corner = number[corner];
  }
  mesh.triangles.push_back(corners);
}

}  // namespace swept
