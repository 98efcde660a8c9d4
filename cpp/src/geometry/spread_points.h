// Spreads points over a triangle, including its border, to compare it with another surface.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace swept {

/// Calls stop(point) for points at most about `spacing` apart. Successive points are neighbours. If
/// a triangle is larger than 32 times the spacing, its sides get 32 steps, so the points are
/// farther apart. Returns true as soon as stop() returns true.
template <class Stop>
bool spreadPoints(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                  double spacing, const Stop& stop) {
  const double ab = (a - b).squaredNorm(), bc = (b - c).squaredNorm(), ca = (c - a).squaredNorm();
  const double longest = std::sqrt(std::max({ab, bc, ca}));
  const double height =
      Eigen::Vector3d(b - a).cross(Eigen::Vector3d(c - a)).norm() / std::max(longest, 1e-300);
  const auto steps = [&](double x) {
    return std::clamp(static_cast<int>(std::ceil(std::min(x / spacing, 32.0))), 2, 32);
  };
  // Rows run along the longest side.
  const Eigen::Vector3d *p = &a, *q = &b, *r = &c;
  if (bc >= ab && bc >= ca) {
    p = &b, q = &c, r = &a;
  } else if (ca >= ab) {
    p = &c, q = &a, r = &b;
  }
  const int n = steps(longest), rows = steps(height);
  for (int i = 0; i <= rows; ++i) {
    const double s = static_cast<double>(i) / rows;
    const int m = std::max(1, static_cast<int>(std::ceil(n * (1 - s))));
    for (int k = 0; k <= m; ++k) {
      const double u = (1 - s) * (i % 2 == 0 ? k : m - k) / m;
      if (stop(Eigen::Vector3d((1 - s - u) * *p + u * *q + s * *r))) return true;
    }
  }
  return false;
}

}  // namespace swept
