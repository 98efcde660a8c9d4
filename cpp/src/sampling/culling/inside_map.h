// A map of the lattice points that certainly lie inside the swept volume, with their depth: the
// distance (in blocks of cells) to the nearest point that may lie outside. An element of the sweep
// lies deep inside if the map shows that it cannot reach the surface of the swept volume.
// In: marked edges and signs of some whole copies of the body. Each copy lies in the swept volume.
// Out: for a box, a triangle or a crossing, whether it can be left out ("hidden").
// Units: cells. Cost: O(lattice points) once; a few look-ups per query.
// Memory: 7 bytes per lattice point in grids of up to kMaxBlocks points; 1 byte per block of cells
// in larger ones.
// Promise: leaving out a hidden crossing changes neither signs nor other crossings. Reason: the
//        search for the outside follows unmarked edges, and further copies only mark more edges. So
//        a lattice point that some copies enclose stays enclosed, and a crossing on an edge between
//        two enclosed points never counts. On an edge with an end outside, only the crossing
//        nearest to that end counts, so one behind a known crossing can be left out.
// Source: docs/pipeline.md, "Culling".
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "grid/grid_plan.h"
#include "grid/marked_edges.h"
#include "signs/signs.h"

namespace swept {

class InsideMap {
 public:
  static constexpr std::size_t kMaxBlocks = std::size_t{1} << 23;

  InsideMap(const MarkedEdges& marked, const SignRuns& signs, const GridPlan& grid);

  /// True if no crossing inside the box (grid coordinates, cells) can matter.
  bool hides(const Eigen::Array3d& low, const Eigen::Array3d& high) const {
    std::size_t at = 0;
    std::int32_t reach = 0;
    for (int axis = 0; axis < 3; ++axis) {
      if (!(low[axis] >= 0) || !(high[axis] < limit_[axis])) return false;
      const std::int32_t a = static_cast<std::int32_t>(low[axis]) >> shift_,
                         b = static_cast<std::int32_t>(high[axis]) >> shift_;
      reach = std::max(reach, (b - a + 1) / 2);
      at = at * blocks_[axis] + static_cast<std::size_t>((a + b) / 2);
    }
    return depth_[at] > reach;
  }

  /// True if no crossing of the triangle can matter, even if its points move by up to `reach` along
  /// each axis (grid coordinates, cells).
  bool hides(const std::array<Eigen::Vector3d, 3>& corner, double reach) const;

  /// True if the crossing at `fraction` of the edge that starts at (i, j, k) along `axis` cannot
  /// matter.
  bool hides(int axis, std::int32_t i, std::int32_t j, std::int32_t k, double fraction) const {
    if (!hasFronts()) return false;
    const Front front = fronts_[axis][pointOf(i, j, k)];
    return fraction * kParts >= front.from && fraction * kParts <= front.to;
  }

  /// Returns whether the map can hide single crossings. It can on grids of at most kMaxBlocks
  /// points.
  bool hasFronts() const { return !fronts_[0].empty(); }
  std::size_t bytes() const { return depth_.size() + 3 * fronts_[0].size() * sizeof(Front); }

 private:
  /// Crossings of an edge in [from, to] / kParts of its length are hidden.
  struct Front {
    std::uint8_t from = kParts, to = 0;
  };
  static constexpr std::uint8_t kParts = 255;

  std::size_t pointOf(std::int32_t i, std::int32_t j, std::int32_t k) const {
    return (static_cast<std::size_t>(i) * blocks_[1] + static_cast<std::size_t>(j)) * blocks_[2] +
           static_cast<std::size_t>(k);
  }
  template <int W>
  bool hidesAlong(const std::array<Eigen::Vector3d, 3>& corner, const Eigen::Vector3d& normal,
                  const Eigen::Array3d& low, const Eigen::Array3d& high, double reach) const;
  void findFronts(const MarkedEdges& marked, const SignRuns& signs, const GridPlan& grid);

  int shift_ = 0;  // a block has 2^shift_ cells along each axis
  Eigen::Array3d limit_ = Eigen::Array3d::Zero();
  std::array<std::size_t, 3> blocks_{};
  /// For each block of cells: the largest distance along any axis, in blocks, to the nearest block
  /// with a corner outside. 0: this block itself has one; the largest value is 255.
  std::vector<std::uint8_t> depth_;
  /// For each axis and lattice point: the hidden part of the edge that starts there. Empty if a
  /// block has several cells.
  std::array<std::vector<Front>, 3> fronts_;
};

}  // namespace swept
