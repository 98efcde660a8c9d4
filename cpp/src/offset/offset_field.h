// Determines for every lattice point on which side of the offset surface it lies.
//
// In:    search for the reach, which is the distance to a cover minus slack (cover_search.h);
//        offset distance; grid.
// Out:   for every lattice point its gap = reach - distance, positive outside. Far from the surface
//        only the sign is correct.
// Method: octree of lattice points. The reaches of two points differ by at most their distance. So
//        a node whose centre is far enough from the surface lies wholly outside or wholly inside.
//        All three axes use the same value for a lattice point, so signs always agree.
// Units: cells. Cost: O(surface cells) queries, 2 kB per block of 8^3 points at the surface,
//        4 bytes per block elsewhere.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "grid/grid_plan.h"
#include "offset/cover_search.h"
#include "swept/run_context.h"

namespace swept::offset {

class OffsetField {
 public:
  static constexpr std::int32_t kBlock = 8;

  OffsetField(const CoverSearch& tree, double distance, const GridPlan& grid, RunContext& run);

  double distance() const { return distance_; }
  /// Returns true for a block if the surface may cross its edges or those to the next blocks. All
  /// points of a block that is not mixed lie on the same side.
  bool isMixed(std::int32_t bi, std::int32_t bj, std::int32_t bk) const {
    return block(bi, bj, bk) >= 0;
  }
  float gap(std::int32_t i, std::int32_t j, std::int32_t k) const {
    const std::int32_t b = block(i / kBlock, j / kBlock, k / kBlock);
    if (b < 0) return b == kOutside ? kFar : -kFar;
    return gaps_[static_cast<std::size_t>(b)][local(i, j, k)];
  }

 private:
  static constexpr float kFar = 2;
  static constexpr std::int32_t kOutside = -1, kInside = -2;
  using Gaps = std::array<float, kBlock * kBlock * kBlock>;
  struct Node {
    std::array<std::int32_t, 3> low;
    std::int32_t hint;
  };

  static std::size_t local(std::int32_t i, std::int32_t j, std::int32_t k) {
    return static_cast<std::size_t>(((i % kBlock) * kBlock + j % kBlock) * kBlock + k % kBlock);
  }
  std::size_t blockIndex(std::int32_t bi, std::int32_t bj, std::int32_t bk) const {
    return (static_cast<std::size_t>(bi) * blocks_[1] + static_cast<std::size_t>(bj)) * blocks_[2] +
           static_cast<std::size_t>(bk);
  }
  std::int32_t block(std::int32_t bi, std::int32_t bj, std::int32_t bk) const {
    return blockOf_[blockIndex(bi, bj, bk)];
  }
  std::vector<Node> refineTo(std::int32_t size, const std::vector<Node>& nodes, RunContext& run);
  void setBlocks(const Node& node, std::int32_t size, std::int32_t kind);
  void fill(const Node& node, std::int32_t size, Gaps& gaps) const;

  const CoverSearch& tree_;
  double distance_;
  std::array<std::int32_t, 3> points_;
  std::array<std::size_t, 3> blocks_{0, 0, 0};
  std::vector<std::int32_t> blockOf_;
  std::vector<Gaps> gaps_;
};

}  // namespace swept::offset
