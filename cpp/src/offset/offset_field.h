// On which side of the offset surface every lattice point lies.
//
// In:    distance to a cover (cover_search.h), offset distance, grid. Out: for every lattice point
//        the gap = reach - distance, above 0 outside; far from the surface only its sign.
// Method: octree of lattice points. The reach changes by at most the distance of two points, so a
//        node whose middle is far enough from the surface is of one kind. One value a lattice
//        point, read by all three axes: signs always agree.
// Units: cells. Cost: O(surface cells) queries, 2 kB a block of 8^3 points at the surface, 4 bytes
//        elsewhere.
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
  /// Blocks that the surface may touch, edges to the next blocks included; others are of one kind.
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
  static constexpr std::int32_t kOutside = -1, kNear = -2;
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
