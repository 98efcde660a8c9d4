// The sampling grid. Lattice point g = (i, j, k), with 0 <= i < points[0] and so on, lies at
// origin + cell * g.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "motion/motion.h"

namespace swept {

/// 13 bits for an index and 17 bits for the position within a cell (snap.h) make 30 bits, so that
/// differences fit into 32 bits.
constexpr int kMaxPointsPerSide = 8191;

struct GridPlan {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< mm
  double cell = 1;                                   ///< mm
  std::array<std::int32_t, 3> points{0, 0, 0};

  std::array<std::int64_t, 3> cells() const {
    return {points[0] - 1, points[1] - 1, points[2] - 1};
  }
  /// Returns the placement that maps a point of the body (mm) to grid coordinates (cells from the
  /// origin).
  Placement toGrid(const Placement& p) const {
    return {p.rotation / cell, (p.translation - origin) / cell, p.timeSeconds};
  }
};

}  // namespace swept
