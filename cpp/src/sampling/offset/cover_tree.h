// Distance to a cover: bounding boxes, four children a node, in float and rounded outward.
// In:    cover triangles. Out: the nearest one, slack taken off its distance.
// Units: cells. Cost: O(n log n) to build, O(log n) a query; about 40 bytes a triangle.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "sampling/offset/cover.h"

namespace swept::offset {

/// Nearest point of a triangle to x.
Eigen::Vector3d nearestOnTriangle(const Eigen::Vector3d& x, const CoverTriangle& triangle);

class CoverTree {
 public:
  /// Keeps a reference to the triangles, sorted by place.
  explicit CoverTree(std::vector<CoverTriangle>& triangles);

  struct Nearest {
    double reach = 0;            ///< distance less slack; `below` if nothing is nearer
    std::int32_t triangle = -1;  ///< -1: nothing is nearer than `below`
  };
  /// hint: a triangle to start from, -1 for none. Nothing at or above `below` is looked for; a
  /// reach of `enough` or less ends the search.
  Nearest nearest(const Eigen::Vector3d& x, double below, std::int32_t hint = -1,
                  double enough = 0) const;

  const CoverTriangle& triangle(std::int32_t index) const { return triangles_[index]; }
  bool empty() const { return triangles_.empty(); }

 private:
  static constexpr int kWidth = 4;
  struct Node {
    float low[3][kWidth], high[3][kWidth];
    /// >= 0: node; < 0: triangle ~child (leaf); kEmpty: none
    std::int32_t child[kWidth];
    static constexpr std::int32_t kEmpty = 0x7fffffff;
  };
  struct Range;
  std::int32_t build(std::size_t first, std::size_t last, std::int32_t node);
  static std::size_t nodesFor(std::size_t count);
  void split(std::size_t first, std::size_t last, std::size_t middle);

  std::vector<CoverTriangle>& triangles_;
  std::vector<Node> nodes_;
};

}  // namespace swept::offset
