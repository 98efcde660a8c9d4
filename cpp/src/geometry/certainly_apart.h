// Cheap answers to "can these two triangles of a mesh meet where they should not?".
// In:    triangles of one mesh. Out: true only if they certainly do not: margins are far above what
//        rounding can do. False says nothing; ask triangle_pairs.h.
// Cost:  some ten nanoseconds, also where the exact predicates are slow (coplanar triangles).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "swept/types.h"

namespace swept {

/// A triangle with the directions along which others are often seen to lie beside it.
struct SeenTriangle {
  static constexpr double kMargin = 2e-14;  ///< some fifty times what rounding can do

  std::array<Eigen::Vector3d, 3> corner;
  std::array<Eigen::Vector3d, 4> axis;  ///< in its plane, outward from each edge; then its normal
  std::array<double, 4> axisSize;
  double size = 0;

  void set(const TriMesh& mesh, std::int32_t t) {
    const auto& tri = mesh.triangles[t];
    for (int i = 0; i < 3; ++i) corner[i] = mesh.vertices[tri[i]];
    const Eigen::Vector3d e0 = corner[1] - corner[0];
    const Eigen::Vector3d e1 = corner[2] - corner[1];
    const Eigen::Vector3d e2 = corner[0] - corner[2];
    axis[3] = e0.cross(e1);
    axis[0] = e0.cross(axis[3]);
    axis[1] = e1.cross(axis[3]);
    axis[2] = e2.cross(axis[3]);
    for (int i = 0; i < 4; ++i) axisSize[i] = axis[i].cwiseAbs().sum();
    size = std::max({e0.cwiseAbs().maxCoeff(), e1.cwiseAbs().maxCoeff(), e2.cwiseAbs().maxCoeff()});
  }

  /// True only if some axis separates this triangle from q for certain.
  bool certainlyApart(const std::array<Eigen::Vector3d, 3>& q) const {
    for (int i = 0; i < 4; ++i) {
      const Eigen::Vector3d& origin = corner[i % 3];
      double least = HUGE_VAL, most = -HUGE_VAL, reach = size;
      for (const auto& point : q) {
        const Eigen::Vector3d d = point - origin;
        const double value = axis[i].dot(d);
        least = std::min(least, value);
        most = std::max(most, value);
        reach = std::max(reach, d.cwiseAbs().maxCoeff());
      }
      const double margin = kMargin * axisSize[i] * reach;
      if (least > margin || (i == 3 && most < -margin)) return true;
    }
    return false;
  }
};

/// Triangles with one, two or no common corner; the same three corners are never apart.
bool certainlyApart(const std::vector<Eigen::Vector3d>& vertices,
                    const std::array<std::int32_t, 3>& p, const std::array<std::int32_t, 3>& q);
inline bool certainlyApart(const TriMesh& mesh, std::int32_t first, std::int32_t second) {
  return certainlyApart(mesh.vertices, mesh.triangles[first], mesh.triangles[second]);
}

/// Exact: repeated corners, or all on one line.
bool hasNoArea(const std::vector<Eigen::Vector3d>& vertices,
               const std::array<std::int32_t, 3>& triangle);
inline bool hasNoArea(const TriMesh& mesh, std::int32_t triangle) {
  return hasNoArea(mesh.vertices, mesh.triangles[triangle]);
}

}  // namespace swept
