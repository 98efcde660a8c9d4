// Finds the faces and side patches of a continuous motion that a segment may meet.
//
// In:    body, motion, placements in grid coordinates. A segment in the same coordinates.
// Out:   all elements near the segment, each once.
// Units: mm in the body, cells in the grid.
// Cost:  O(n log n) to build, for n faces and placements. A search takes time for the elements near
//        the segment, hardly for all others.
// Promise: no element that meets the segment is missed. The order is fixed.
// Source: own method; docs/contouring.md, "Rims".
//
// There are two trees: one of balls around faces, one of blocks of successive steps. A block bounds
// where its placements carry the body: an affine map and the largest deviation from it. The map
// takes a ball to a ball that contains all copies and side patches of its faces in the block. A
// search descends both trees at once. It divides the ball or the block, whichever contributes more
// to the size of the bound.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <vector>

#include "sampling/sampler.h"

namespace swept {

class SweepTree {
 public:
  /// `placements`: the placements of the motion, from body coordinates to grid coordinates. The
  /// arguments must outlive the tree.
  SweepTree(const SamplerInput& input, const std::vector<Placement>& placements);

  /// Calls use(element) for each element that may meet the segment from `from` to `from` + `reach`
  /// * `way`. `use` may lower `reach`; the search then leaves out what lies beyond.
  template <class Use>
  void along(const Eigen::Vector3d& from, const Eigen::Vector3d& way, const double& reach,
             const Use& use) const {
    const Search<Use> search{*this, from, way, way.squaredNorm(), reach, use};
    typename Search<Use>::Pair whole{levels_.size() - 1, 0, 0};
    if (search.meets(whole)) search.visit(whole);
  }

 private:
  /// A ball around the faces [begin, end) of faces_. `left` and `right` are its halves, or 0.
  struct Ball {
    Eigen::Vector3d arm;  // from the centre of the body to the centre of the ball, mm
    double radius = 0, distance = 0;  // mm; distance: length of the arm
    std::uint32_t begin = 0, end = 0, left = 0, right = 0;
  };
  /// The placements of some successive steps: x -> turn * (x - centre of the body) + place.
  struct Block {
    Eigen::Matrix3d turn;
    Eigen::Vector3d place;
    double placeSpread = 0;  // cells, largest deviation at the centre of the body
    double turnSpread = 0;   // further deviation per mm of distance from the centre
  };

  template <class Use>
  struct Search {
    const SweepTree& tree;
    const Eigen::Vector3d &from, &way;
    double square;
    const double& reach;
    const Use& use;

    /// A pair of a block and a ball, and the fraction of the segment at which it comes nearest.
    struct Pair {
      std::size_t level, at;
      std::uint32_t ball;
      double along = 0;
      bool divideBlock = false;
    };

    /// Returns whether the bound of the pair meets the segment.
    bool meets(Pair& pair) const {
      const Ball& ball = tree.balls_[pair.ball];
      const Block& block = tree.levels_[pair.level][pair.at];
      const double spread = block.placeSpread + block.turnSpread * (ball.distance + ball.radius);
      const double own = ball.radius * tree.scale_, radius = own + spread + kSlack;
      const Eigen::Vector3d off = block.turn * ball.arm + block.place - from;
      pair.along = square > 0 ? std::clamp(off.dot(way) / square, 0.0, std::min(reach, 1.0)) : 0;
      pair.divideBlock = pair.level > 0 && (ball.left == 0 || spread > own);
      return (off - pair.along * way).squaredNorm() <= radius * radius;
    }

    /// Calls use(element) for the faces of a ball at a placement, and for the side patches of the
    /// step that starts there. First tests the ball at the placement, and its way during the step.
    void elements(const Ball& ball, std::uint32_t placement) const {
      const Eigen::Vector3d centre = tree.centre_ + ball.arm;
      const Eigen::Vector3d start = tree.placements_[placement].apply(centre);
      const double radius = ball.radius * tree.scale_ + kSlack, most = radius * radius;
      const Eigen::Vector3d end = from + std::min(reach, 1.0) * way;
      const bool face = squaredDistance(from, end, start, start) <= most;
      const bool patches =
          placement < tree.input_.motion.steps() &&
          squaredDistance(from, end, start, tree.placements_[placement + 1].apply(centre)) <= most;
      for (std::uint32_t n = ball.begin; n < ball.end; ++n) {
        const std::uint32_t number = tree.faces_[n];
        if (face) use(SweptElement{number, placement});
        if (!patches) continue;
        for (std::uint32_t e = tree.firstEdge_[number]; e < tree.firstEdge_[number + 1]; ++e) {
          use(SweptElement{tree.edges_[e] | SweptElement::kSidePatchBit, placement});
        }
      }
    }

    void visit(const Pair& pair) const {
      const Ball& ball = tree.balls_[pair.ball];
      Pair first = pair, second = pair;
      bool hasSecond = true;
      if (pair.divideBlock) {
        first.level = second.level = pair.level - 1;
        first.at = 2 * pair.at;
        second.at = first.at + 1;
        hasSecond = second.at < tree.levels_[first.level].size();
      } else if (ball.left != 0) {
        first.ball = ball.left;
        second.ball = ball.right;
      } else {
        elements(ball, static_cast<std::uint32_t>(pair.at));
        return;
      }
      const bool one = meets(first), two = hasSecond && meets(second);
      // The nearer one first: its hits may end the segment before the other one.
      const bool swap = two && second.along < first.along;
      if (swap) {
        visit(second);
        if (one && meets(first)) visit(first);
      } else {
        if (one) visit(first);
        if (two && (!one || meets(second))) visit(second);
      }
    }
  };
  static constexpr double kSlack = 1e-6;  // cells; covers rounding and widened triangles

  /// Returns the squared distance of two segments.
  static double squaredDistance(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                const Eigen::Vector3d& c, const Eigen::Vector3d& d);
  std::uint32_t build(std::uint32_t begin, std::uint32_t end);
  void buildBlocks(const std::vector<Placement>& placements);

  const SamplerInput& input_;
  const std::vector<Placement>& placements_;
  double scale_;                                        // cells per mm
  Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();  // of the body, mm
  std::vector<std::uint32_t> faces_;      // in the order of the leaves
  std::vector<std::uint32_t> firstEdge_;  // by face: its range in edges_
  std::vector<std::uint32_t> edges_;      // each edge belongs to the face on its left
  std::vector<Ball> balls_;
  std::vector<std::vector<Block>> levels_;  // blocks of 1, 2, 4, ... steps
};

}  // namespace swept
