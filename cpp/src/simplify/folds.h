// Folds of a surface: places where triangles are turned away from each other. There, a point can be
// near triangles that do not replace its own, so the simplification tests more.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

namespace swept {

/// Returns whether two triangles, or a triangle and the mean of its neighbours, are turned by more
/// than 46 degrees. `area`, `other`: their area vectors.
inline bool isFold(const Eigen::Vector3d& area, const Eigen::Vector3d& other) {
  constexpr double kCosine = 0.7;
  return area.dot(other) < kCosine * area.norm() * other.norm();
}

}  // namespace swept
