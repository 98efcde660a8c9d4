// Which lattice points are known to lie inside the swept volume, and how deep: what lies deep
// inside cannot reach the surface.
//
// In: marked edges and signs of some true pieces of the sweep (whole copies of the body). Out: for
// a box, whether crossings within it can matter. Units: cells. Cost: O(lattice points) once; a few
// look-ups for a query. Memory: 7 bytes a lattice point up to kMaxBlocks of them; beyond, one byte
// for each block of several. Promise: a crossing that is hidden changes neither signs nor other
// crossings. The outside of the whole sweep is reached along unmarked edges, and more pieces only
// mark more edges, so that what a part of the sweep encloses stays enclosed: an edge between two
// enclosed points has no outside end and is never walked. On an edge with an outside end only the
// first crossing from there counts, and a crossing behind a known one is not the first. Source:
// METHOD.md section 2, "what is inside stays inside".
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

  /// Whether no crossing within the box (grid coordinates, cells) can matter.
  bool hides(const Eigen::Array3d& low, const Eigen::Array3d& high) const {
    std::size_t at = 0;
    std::int32_t reach = 0;
    std::array<std::int32_t, 3> first, last;
    for (int axis = 0; axis < 3; ++axis) {
      if (!(low[axis] >= 0) || !(high[axis] < limit_[axis])) return false;
      first[axis] = static_cast<std::int32_t>(low[axis]);
      last[axis] = static_cast<std::int32_t>(high[axis]);
      const std::int32_t a = first[axis] >> shift_, b = last[axis] >> shift_;
      reach = std::max(reach, (b - a + 1) / 2);
      at = at * blocks_[axis] + static_cast<std::size_t>((a + b) / 2);
    }
    if (depth_[at] > reach) return true;
    return hasFronts() && depth_[at] + kFrontCells >= reach && behindFronts(low, high, first, last);
  }

 private:
  /// Larger boxes are only compared with what is deep inside.
  static constexpr std::int32_t kFrontCells = 3;
  /// Crossings of an edge in [from, to] / kParts of its length are hidden.
  struct Front {
    std::uint8_t from = kParts, to = 0;
  };
  static constexpr std::uint8_t kParts = 255;

  bool hasFronts() const { return !fronts_[0].empty(); }
  bool behindFronts(const Eigen::Array3d& low, const Eigen::Array3d& high,
                    const std::array<std::int32_t, 3>& first,
                    const std::array<std::int32_t, 3>& last) const;
  void findFronts(const MarkedEdges& marked, const SignRuns& signs, const GridPlan& grid);

  int shift_ = 0;  // blocks have 2^shift_ cells along each axis
  Eigen::Array3d limit_ = Eigen::Array3d::Zero();
  std::array<std::size_t, 3> blocks_{};
  /// Per block of cells: how many blocks along any axis to the nearest one that has a corner
  /// outside (0: itself); at most 255.
  std::vector<std::uint8_t> depth_;
  /// Per axis and lattice point: of the edge that starts there; empty if blocks are not cells.
  std::array<std::vector<Front>, 3> fronts_;
};

}  // namespace swept
