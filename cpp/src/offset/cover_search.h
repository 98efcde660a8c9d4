// Distance to a cover.
// In:    cover triangles. Out: the nearest one, slack taken off its distance.
// Units: cells. Cost: O(n) to build, O(log n) a query; 36 bytes a triangle.
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
  /// Keeps a reference to the triangles, sorted by place.
  explicit CoverSearch(std::vector<CoverTriangle>& triangles);

  struct Nearest {
    double reach = 0;            ///< distance less slack; `below` if nothing is nearer
    std::int32_t triangle = -1;  ///< -1: nothing is nearer than `below`
  };
  /// hint: a triangle to start from, -1 for none. Nothing at or above `below` is looked for; a
  /// reach of `enough` or less ends the search.
  Nearest nearest(const Eigen::Vector3d& x, double below, std::int32_t hint = -1,
                  double enough = 0) const;

  /// Calls visit(number of a triangle) for each whose box, slack included, comes within `distance`
  /// of a box.
  template <class Visit>
  void forNear(const Eigen::Vector3d& low, const Eigen::Vector3d& high, double distance,
               const Visit& visit) const {
    const Eigen::Vector3d room = Eigen::Vector3d::Constant(distance);
    tree_.forBox(low - room, high + room,
                 [&](std::uint32_t place) { visit(static_cast<std::int32_t>(place)); });
  }

  const CoverTriangle& triangle(std::int32_t index) const { return triangles_[index]; }

 private:
  std::vector<CoverTriangle>& triangles_;
  BoxTree tree_;
};

}  // namespace swept::offset
