// The placements of a dense motion as points in six dimensions, and support queries over them.
//
// In: body, placements. Out: the placement with the largest advance along a normal.
// Units: mm. The turn w is multiplied by the body's radius, so that all six coordinates are
// lengths.
// Cost: O(n log n) to build; microseconds per query.
// Promise: of placements with equal advance, the one with the lowest index wins, so results are the
// same for any number of threads.
// Source: docs/pipeline.md, "Dense motions".
//
// Let a body point have the position c + q at a mean placement (c: centre of the body). At another
// placement, it has moved by dt + w x q, to first order in the turn w. So its advance along a unit
// normal n is n.dt + (q x n).w, which is linear in the point (dt, w). Therefore a support query
// finds the placement that moves a piece of surface farthest. It uses branch and bound over a tree
// of boxes. remainder() is the error of the linear form in any direction, to second order: radius *
// |w|^2 / 2.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "motion/motion.h"
#include "swept/types.h"

namespace swept::dense {

using Point6 = std::array<float, 6>;

inline float dot(const Point6& a, const Point6& b) {
  return ((a[0] * b[0] + a[1] * b[1]) + (a[2] * b[2] + a[3] * b[3])) + (a[4] * b[4] + a[5] * b[5]);
}

class PlacementSpace {
 public:
  struct Best {
    std::uint32_t placement = 0;
    float advance = -1e30f;
  };

  enum Wanted { kAll, kExtentOnly };
  /// With kExtentOnly, only measures how much the placements differ and builds no tree for queries.
  PlacementSpace(const TriMesh& body, const std::vector<Placement>& placements,
                 Wanted wanted = kAll);

  /// Returns the gradient of the advance: the advance along n (unit, body frame) at body point x is
  /// dot(gradient(x, n), point(placement)).
  Point6 gradient(const Eigen::Vector3d& x, const Eigen::Vector3d& n) const;
  const Point6& point(std::uint32_t placement) const { return points_[placement]; }
  /// Returns the placement with the largest advance. `guess`: a placement with which the search
  /// starts; it only affects the speed.
  Best support(const Point6& gradient, std::uint32_t guess) const;
  /// Collects placements with an advance above `minAdvance` in `out`, unsorted. Stops after
  /// `maxCount` placements. Branches of the tree with higher bounds are searched first, but the
  /// placements found need not be the best ones.
  void above(const Point6& gradient, float minAdvance, std::size_t maxCount,
             std::vector<Best>& out) const;

  const Placement& mean() const { return mean_; }
  double remainder() const { return remainder_; }  ///< mm
  double reach() const { return reach_; }          ///< mm: largest |dt| + |w| * radius
  double turn() const { return turn_; }            ///< rad: largest |w|

 private:
  struct Node {
    Point6 low, high;
    std::uint32_t begin = 0, end = 0;
    /// Index of the second child; the first child follows directly. 0: leaf.
    std::uint32_t right = 0;
  };
  std::uint32_t build(std::uint32_t begin, std::uint32_t end);
  template <class IsWanted, class Visit>
  void descend(const Point6& gradient, const IsWanted& isWanted, const Visit& visit) const;
  /// A gradient split into its positive and its negative part. For a bound over a box, the positive
  /// part is multiplied by the upper limits of the box, the negative part by the lower limits.
  struct Split {
    Point6 up, down;
    explicit Split(const Point6& g) {
      for (std::size_t a = 0; a < 6; ++a) {
        up[a] = g[a] > 0 ? g[a] : 0;
        down[a] = g[a] > 0 ? 0 : g[a];
      }
    }
  };
  static float bound(const Node& node, const Split& g) {
    return dot(g.up, node.high) + dot(g.down, node.low);
  }

  Placement mean_;
  Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();  // body frame
  double radius_ = 0, remainder_ = 0, reach_ = 0, turn_ = 0;
  std::vector<Point6> points_;        // by placement
  std::vector<Point6> sorted_;        // in the order of the tree
  std::vector<std::uint32_t> order_;  // sorted_[i] is placement order_[i]
  std::vector<Node> nodes_;
};

}  // namespace swept::dense
