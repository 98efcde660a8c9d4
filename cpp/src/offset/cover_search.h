// Finds the nearest triangle of a cover (cover.h).
// The reach of a point is the smallest value of "distance to the triangle minus slack of the
// triangle" over all triangles.
// In:    cover triangles. Out: the triangle that gives the reach, and the reach.
// Units: cells. Cost: O(n) to build for n triangles, O(log n) per query; 36 bytes per triangle.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "geometry/box_tree.h"
#include "geometry/triangle_distance.h"
#include "offset/cover.h"

namespace swept::offset {

inline Eigen::Vector3d nearestOnTriangle(const Eigen::Vector3d& x, const CoverTriangle& triangle) {
  return footOnTriangle(x, triangle.corner).point;
}

class CoverSearch {
 public:
  /// Sorts `triangles` by position, in place, and keeps a reference to them.
  explicit CoverSearch(std::vector<CoverTriangle>& triangles);

  struct Nearest {
    double reach = 0;            ///< distance minus slack; `below` if no triangle is nearer
    std::int32_t triangle = -1;  ///< -1: no triangle is nearer than `below`
  };
  /// Finds the triangle that gives the reach of x, if the reach is smaller than `below`. `hint`: a
  /// triangle with which the search starts (-1: none). The search ends early at a triangle for
  /// which distance minus slack is at most `enough`.
  Nearest nearest(const Eigen::Vector3d& x, double below, std::int32_t hint = -1,
                  double enough = 0) const;

  /// Calls visit(index) for each triangle whose bounding box, enlarged by its slack, comes within
  /// `distance` of the box from `low` to `high`.
  template <class Visit>
  void forNear(const Eigen::Vector3d& low, const Eigen::Vector3d& high, double distance,
               const Visit& visit) const {
    const Eigen::Vector3d margin = Eigen::Vector3d::Constant(distance);
    tree_.forBox(low - margin, high + margin,
                 [&](std::uint32_t index) { visit(static_cast<std::int32_t>(index)); });
  }

  const CoverTriangle& triangle(std::int32_t index) const { return triangles_[index]; }

 private:
  std::vector<CoverTriangle>& triangles_;
  BoxTree tree_;
};

}  // namespace swept::offset
