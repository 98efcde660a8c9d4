// The placements of a dense motion as points in six dimensions, and support queries over them.
//
// Relative to a mean placement, a body point with mean position c + q moves by dt + w x q (first
// order in the turn w), so its advance along a unit normal n is n.dt + (q x n).w: linear in the
// point (dt, w). How far a placement pushes a bit of surface is a dot product, and which one pushes
// it farthest is a support query, answered by branch and bound over a tree of boxes.
// Units: mm; w is scaled by the body's radius, so that all six coordinates are lengths.
// Remainder: radius * |w|^2 / 2 bounds what the linear form leaves out along any direction, to
// second order (remainder()).
// Cost: O(n log n) to build; microseconds a query. Deterministic: equal values go to the lower
// index.
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
  /// kExtentOnly: no tree and no questions, only how far the placements differ.
  PlacementSpace(const TriMesh& body, const std::vector<Placement>& placements,
                 Wanted wanted = kAll);

  /// Advance along n (unit, body frame) at body point x is dot(gradient(x, n), point(placement)).
  Point6 gradient(const Eigen::Vector3d& x, const Eigen::Vector3d& n) const;
  const Point6& point(std::uint32_t placement) const { return points_[placement]; }
  /// The placement of largest advance; `guess` speeds it up and does not change the answer.
  Best support(const Point6& gradient, std::uint32_t guess) const;
  /// Up to `most` placements of advance above `least`, best branches first.
  void above(const Point6& gradient, float least, std::size_t most, std::vector<Best>& out) const;

  const Placement& mean() const { return mean_; }
  double remainder() const { return remainder_; }  ///< mm
  double reach() const { return reach_; }          ///< mm: largest |dt| + |w| radius
  double turn() const { return turn_; }            ///< rad, largest |w|

 private:
  struct Node {
    Point6 low, high;
    std::uint32_t begin = 0, end = 0;
    std::uint32_t right = 0;  ///< index of the second child, the first follows; 0: leaf
  };
  std::uint32_t build(std::uint32_t begin, std::uint32_t end);
  /// A gradient as the boxes are asked: its positive part meets their high sides, the rest the low.
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
