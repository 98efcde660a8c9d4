// Snaps vertices to the fine lattice on which all samplers decide exactly.
//
// The order of the additions is fixed, so that a shader with the same order computes the same bits.
// Source: own method; docs/pipeline.md, "Sampling".
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstdint>

#include "motion/motion.h"

namespace swept {

constexpr int kSubBits = 17;
constexpr std::int32_t kSubUnits = 1 << kSubBits;
using SnappedPoint = std::array<std::int32_t, 3>;

/// Rounds a grid coordinate (cells, > 0) to an odd integer in units of 2^-17 cell.
inline std::int32_t snapCoordinate(double g) {
  return 2 * static_cast<std::int32_t>(g * (kSubUnits / 2)) + 1;
}

/// Snaps the point p(x). `p` is a placement in grid coordinates (GridPlan::toGrid()).
inline SnappedPoint snap(const Placement& p, const Eigen::Vector3d& x) {
  SnappedPoint out;
  for (int axis = 0; axis < 3; ++axis) {
    out[axis] = snapCoordinate(
        ((p.rotation(axis, 0) * x[0] + p.rotation(axis, 1) * x[1]) + p.rotation(axis, 2) * x[2]) +
        p.translation[axis]);
  }
  return out;
}

/// Returns whether a lattice line can meet a box, given the cells of its two corners. A line along
/// one axis can only if the corners lie in different cells along both other axes.
template <class Cell>
bool meetsLines(const Cell& low, const Cell& high) {
  return int{low[0] != high[0]} + int{low[1] != high[1]} + int{low[2] != high[2]} >= 2;
}

/// The bounding box of some snapped points.
struct SnappedBox {
  SnappedPoint low, high;

  template <class... Points>
  explicit SnappedBox(const SnappedPoint& first, const Points&... others)
      : low(first), high(first) {
    for (const SnappedPoint* point : {&others...}) {
      for (int axis = 0; axis < 3; ++axis) {
        low[axis] = std::min(low[axis], (*point)[axis]);
        high[axis] = std::max(high[axis], (*point)[axis]);
      }
    }
  }
  bool meetsLines() const {
    const auto cell = [](const SnappedPoint& p) {
      return SnappedPoint{p[0] >> kSubBits, p[1] >> kSubBits, p[2] >> kSubBits};
    };
    return swept::meetsLines(cell(low), cell(high));
  }
};

}  // namespace swept
