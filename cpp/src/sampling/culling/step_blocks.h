// Which clusters of faces need to be looked at at which placements: blocks of placements are
// decided as a whole, and what they leave out is not looked at again one by one.
//
// In: body, motion, clusters, and, where known, what lies inside. Out: the clusters shown at every
// placement. Units: mm, cells. Cost: that of the clusters that are shown, and O(placements).
// Promise: what is left out crosses no line of the lattice, or its crossings cannot matter
// (inside_map.h): the marks that count are the same to the last bit.
// Source: own method; METHOD.md section 2, "Dense motions", space-time subdivision.
//
// A block bounds where its placements, and the steps that start at them, carry the body: an affine
// map, and how far they leave it. A box round a cluster's ball at that map holds all its copies and
// side patches. Blocks are of two kinds: neighbours in time, of 8 and 64 placements; and neighbours
// in place, since a recording comes back to the same places over and over (PlaceGroups).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "sampling/culling/kept_elements.h"

namespace swept {

/// Where some placements carry the body: x -> turn (x - centre of the body) + place, in cells.
struct PlaceBlock {
  Eigen::Matrix3d turn;
  Eigen::Vector3d place;
  double placeSpread = 0;  ///< how far they leave the map at the centre, cells
  double turnSpread = 0;   ///< and how much more for each mm of distance from it
};

/// The body about its centre, and the placements as numbers that can be bounded by boxes.
class PlaceBounds {
 public:
  PlaceBounds(const SamplerInput& input, const FaceClusters& clusters);

  /// Bounds of the nine numbers of a matrix and the three of a vector.
  struct Box {
    using Map = Eigen::Array<double, 12, 1>;
    Map low = Map::Constant(1e300), high = -low;
    void add(const Box& other) {
      low = low.min(other.low);
      high = high.max(other.high);
    }
  };
  /// The placement k and the step that starts there.
  Box boxOf(std::size_t k) const;
  static PlaceBlock blockOf(const Box& box);

  /// Whether the copies and side patches of a cluster in these placements can matter.
  bool shows(const PlaceBlock& block, const FaceCluster& cluster) const;
  /// The same for one face of it.
  bool shows(const PlaceBlock& block, std::uint32_t face) const;
  bool hasInside() const { return input_.inside != nullptr; }
  double radius() const { return radius_; }  ///< mm

 private:
  const SamplerInput& input_;
  Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();
  double radius_ = 0;
};

/// Groups of placements that are a small part of a cell apart, whenever they come, each with the
/// clusters that it shows. Empty unless placements come back to the same places.
class PlaceGroups {
 public:
  /// Decides only the groups of these placements, and says what the others would take.
  struct Trial {
    std::vector<PlacementRange> only;
    double secondsOfOthers = 0;  ///< CPU seconds, on one thread
  };

  PlaceGroups(const SamplerInput& input, const FaceClusters& clusters, RunContext& run,
              Trial* trial = nullptr);

  bool empty() const { return shown_.empty(); }
  const ShownClusters& shownAt(std::size_t placement) const { return shown_[groupOf_[placement]]; }

 private:
  /// Boxes of the groups of this size, and the group of each placement; ends early if there are too
  /// many to be worth it.
  static std::vector<PlaceBounds::Box> group(const std::vector<PlaceBounds::Box>& boxes,
                                             double cells, double radius,
                                             std::vector<std::uint32_t>& groupOf);

  std::vector<std::uint32_t> groupOf_;  // per placement
  std::vector<ShownClusters> shown_;    // per group
};

class StepBlocks {
 public:
  /// Of the placements [begin, end).
  StepBlocks(const SamplerInput& input, const FaceClusters& clusters, const PlaceGroups& groups,
             std::size_t begin, std::size_t end);

  /// Calls use(placement, shown) for the placements that show clusters, in rising order, and
  /// passed(placement) now and then.
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
  static constexpr std::size_t kShift = 3, kMostLevels = 2;

  /// level 0: a placement.
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
  /// What of the clusters is shown at one placement.
  const ShownClusters& narrow(std::size_t at, const ShownClusters& above);

  const FaceClusters& clusters_;
  const PlaceGroups& groups_;
  PlaceBounds bounds_;
  std::size_t parts_, begin_, end_;
  bool narrows_ = false;  // whether a look at single placements can leave anything out
  std::vector<std::vector<PlaceBlock>> levels_;  // blocks of 8, of 64 placements
  std::vector<PlaceBlock> single_;               // placements
  std::vector<ShownClusters> below_;             // by level
};

}  // namespace swept
