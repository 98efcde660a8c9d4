// Which clusters of faces need to be looked at in which steps: blocks of steps are decided as a
// whole, and what they leave out is not looked at again step by step.
//
// In: body, motion, clusters, and, where known, what lies deep inside. Out: the live pieces of
// every placement. Units: mm, cells. Cost: that of the pieces that stay, and O(placements).
// Promise: what is dropped for its direction is what KeptElements would drop, and what is dropped
// for its depth changes neither signs nor crossings (inside_map.h): the marks that count are the
// same to the last bit. Source: own method; METHOD.md section 2, "Dense motions", space-time
// subdivision.
//
// A block of 2^level steps bounds two things in boxes, which are joined from two blocks to the one
// above them. Where its placements carry the body: an affine map and how far they leave it, so that
// a ball round a cluster's ball holds all its copies and side patches. How its steps move the body,
// as seen from the body and divided by how far they go: where all of them move a cluster the same
// way, only its border with others is left.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "sampling/culling/kept_elements.h"

namespace swept {

class StepBlocks {
 public:
  /// Of the placements [begin, end) and the steps that start at them.
  StepBlocks(const SamplerInput& input, const FaceClusters& clusters, std::size_t begin,
             std::size_t end);

  /// Calls use(placement, live) for the placements that have live pieces, in rising order, and
  /// passed(placement) now and then.
  template <class Passed, class Use>
  void forPlacements(const Passed& passed, const Use& use) {
    const LivePieces all = LivePieces::all(clusters_);
    const std::size_t top = levels_.size() - 1;
    for (std::size_t block = 0; block < levels_[top].size(); ++block) {
      passed(begin_ + (block << top));
      visit(top, block, all, use);
    }
  }

 private:
  static constexpr std::size_t kTopLevel = 8;

  struct Block {
    /// Placements, in cells: x -> turn (x - centre of the body) + place, and how far they leave it.
    Eigen::Matrix3d turn;
    Eigen::Vector3d place;
    double placeSpread = 0, turnSpread = 0;  // at the centre, and per mm of distance from it
    /// Steps divided by their length: x -> bend (x - centre) + way.
    Eigen::Matrix3d bend;
    Eigen::Vector3d way;
    double waySpread = 0, bendSpread = 0;
    double angle = 0, anglePerLength = 0, perLength = 0;  // largest of its steps
    bool moves = false;                                   // all its steps have a length
    bool hasFirst = false, hasLast = false;               // placement of the motion
  };
  struct Boxes;

  Boxes boxesOf(std::size_t placement) const;
  static Block blockOf(const Boxes& boxes);
  bool isHidden(const Block& block, const FaceCluster& cluster) const;
  int directionOf(const Block& block, const FaceCluster& cluster) const;
  /// Fills below_[level] with what is left of the pieces above.
  void narrow(std::size_t level, std::size_t block, const LivePieces& above);

  template <class Use>
  void visit(std::size_t level, std::size_t block, const LivePieces& above, const Use& use) {
    const std::size_t undo = decided_.size();
    narrow(level, block, above);
    const LivePieces& live = below_[level];
    if (level == 0) {
      if (!live.empty()) use(begin_ + block, live);
    } else if (!live.empty()) {
      visit(level - 1, 2 * block, live, use);
      if (2 * block + 1 < levels_[level - 1].size()) visit(level - 1, 2 * block + 1, live, use);
    }
    for (; decided_.size() > undo; decided_.pop_back()) direction_[decided_.back()] = 0;
  }

  const SamplerInput& input_;
  const FaceClusters& clusters_;
  std::size_t begin_;
  Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();  // of the body
  double radius_ = 0;                                 // mm, of the body about its centre
  std::vector<std::vector<Block>> levels_;
  std::vector<LivePieces> below_;  // by level
  // Per cluster, for the block that is visited: known from it or a block above it.
  std::vector<std::int8_t> direction_;
  std::vector<std::uint32_t> decided_;  // clusters with a direction, in the order of the blocks
  enum Depth : std::uint8_t { kNotAsked, kShown, kHidden };
  std::vector<std::uint8_t> depth_;
};

}  // namespace swept
