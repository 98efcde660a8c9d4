// Decides which clusters of faces can matter (have crossings that change the result) at which
// placements. These clusters are "shown", all others are hidden. A block of placements is decided
// as a whole: a cluster that is hidden for the block is not tested again at the placements of the
// block.
//
// In: body, motion, clusters and, if there is one, the map of the inside.
// Out: the clusters shown at every placement.
// Units: mm, cells. Cost: O(shown clusters + placements).
// Promise: an element that is left out crosses no lattice line, or its crossings cannot matter
//        (inside_map.h). The marked edges that count are the same to the last bit.
// Source: own method (docs/pipeline.md, "Culling").
//
// A block bounds where its placements, and the steps that start at them, carry the body. The bound
// is an affine map and the largest deviation from it. The map takes the bounding ball of a cluster
// to a box that contains all its copies and side patches. There are two kinds of blocks: 8 or 64
// successive placements; and PlacementGroups, which are placements at nearly the same position and
// orientation. A recorded motion often returns to such placements.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "sampling/culling/kept_elements.h"

namespace swept {

/// Bounds on a group of placements. Each placement maps a point x of the body to about turn * (x -
/// centre of the body) + position, in cells.
struct PlacementBlock {
  Eigen::Matrix3d turn;
  Eigen::Vector3d position;
  double positionSpread = 0;  ///< largest deviation at the centre, cells
  double turnSpread = 0;      ///< further deviation, cells per mm of distance from the centre
};

/// Computes bounds of placements. A placement is treated as a vector of twelve numbers, and a box
/// bounds each of these numbers.
class PlacementBounds {
 public:
  PlacementBounds(const SamplerInput& input, const FaceClusters& clusters);

  /// Bounds of the nine entries of a matrix and the three of a vector.
  struct Box {
    using Map = Eigen::Array<double, 12, 1>;
    Map low = Map::Constant(1e300), high = -low;
    void add(const Box& other) {
      low = low.min(other.low);
      high = high.max(other.high);
    }
  };
  /// Returns bounds of the placement k and of the step that starts there.
  Box boxOf(std::size_t k) const;
  static PlacementBlock blockOf(const Box& box);

  /// Returns whether the copies and side patches of a cluster at the placements of the block can
  /// matter.
  bool shows(const PlacementBlock& block, const FaceCluster& cluster) const;
  /// Returns whether the copies of one face can matter. Requires the map of the inside.
  bool shows(const PlacementBlock& block, std::uint32_t face) const;
  bool hasInside() const { return input_.inside != nullptr; }
  double radius() const { return radius_; }  ///< mm

 private:
  const SamplerInput& input_;
  Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();
  double radius_ = 0;
};

/// Groups of placements that differ by at most a few cells, at any times of the motion, with the
/// clusters that each group shows. Empty without a map of the inside, or if the motion rarely
/// returns to the same placements.
class PlacementGroups {
 public:
  /// For a trial: the constructor only decides the groups that contain placements of `only`, and
  /// estimates the time for the other groups.
  struct Trial {
    std::vector<PlacementRange> only;
    double secondsOfOthers = 0;  ///< CPU seconds, on one thread
  };

  PlacementGroups(const SamplerInput& input, const FaceClusters& clusters, RunContext& run,
                  Trial* trial = nullptr);

  bool empty() const { return shown_.empty(); }
  const ShownClusters& shownAt(std::size_t placement) const { return shown_[groupOf_[placement]]; }

 private:
  /// Groups placements so that no group is larger than `cells`. Returns the boxes of the groups,
  /// and sets the group of each placement. Ends early if there are too many groups to save time.
  static std::vector<PlacementBounds::Box> group(const std::vector<PlacementBounds::Box>& boxes,
                                                 double cells, double radius,
                                                 std::vector<std::uint32_t>& groupOf);

  std::vector<std::uint32_t> groupOf_;  // per placement
  std::vector<ShownClusters> shown_;    // per group
};

class StepBlocks {
 public:
  /// Builds the blocks for the placements [begin, end).
  StepBlocks(const SamplerInput& input, const FaceClusters& clusters, const PlacementGroups& groups,
             std::size_t begin, std::size_t end);

  /// Calls use(placement, shown) in ascending order for all placements at which clusters are shown.
  /// Calls passed(placement) once per block, to report progress.
  template <class Passed, class Use>
  void forPlacements(const Passed& passed, const Use& use) {
    const ShownClusters all = allClusters(clusters_, parts_);
    const std::size_t top = levels_.size();
    const std::size_t count = levels_.empty() ? end_ - begin_ : levels_.back().size();
    for (std::size_t block = 0; block < count; ++block) {
      passed(begin_ + (block << (kShift * top)));
      visit(top, block, all, use);
    }
  }

 private:
  static constexpr std::size_t kShift = 3, kMaxLevels = 2;

  /// Visits the block `at` of a level. At level 0, a block is a single placement.
  template <class Use>
  void visit(std::size_t level, std::size_t at, const ShownClusters& above, const Use& use) {
    if (level == 0) {
      const ShownClusters& shown = narrow(at, above);
      if (!shown.empty() || !clusters_.innerEnds.empty()) use(begin_ + at, shown);
      return;
    }
    ShownClusters& shown = below_[level];
    shown.clear();
    for (const ShownCluster& s : above) {
      if (bounds_.shows(levels_[level - 1][at], clusters_.clusters[s.cluster])) shown.push_back(s);
    }
    const std::size_t count = level == 1 ? end_ - begin_ : levels_[level - 2].size();
    const std::size_t end = std::min((at + 1) << kShift, count);
    for (std::size_t child = at << kShift; child < end; ++child) {
      visit(level - 1, child, shown, use);
    }
  }
  /// Returns the clusters of `above` that one placement shows.
  const ShownClusters& narrow(std::size_t at, const ShownClusters& above);

  const FaceClusters& clusters_;
  const PlacementGroups& groups_;
  PlacementBounds bounds_;
  std::size_t parts_, begin_, end_;
  bool narrows_ = false;  // true if tests of single placements can hide anything
  std::vector<std::vector<PlacementBlock>> levels_;  // blocks of 8 and of 64 placements
  std::vector<PlacementBlock> single_;               // single placements
  std::vector<ShownClusters> below_;                 // by level
};

}  // namespace swept
