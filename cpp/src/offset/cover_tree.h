// Distance to a cover: bounding boxes, four children a node, in float and rounded outward.
// In:    cover triangles. Out: the nearest one, slack taken off its distance.
// Units: cells. Cost: O(n log n) to build, O(log n) a query; about 40 bytes a triangle.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "offset/cover.h"

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

  /// Calls visit(number of a triangle) for each whose box, slack included, comes within `distance`
  /// of a box.
  template <class Visit>
  void forNear(const Eigen::Vector3d& low, const Eigen::Vector3d& high, double distance,
               const Visit& visit) const;

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

template <class Visit>
void CoverTree::forNear(const Eigen::Vector3d& low, const Eigen::Vector3d& high, double distance,
                        const Visit& visit) const {
  if (nodes_.empty()) return;
  std::int32_t stack[128];
  int top = 0;
  stack[top++] = 0;
  while (top > 0) {
    const Node& node = nodes_[static_cast<std::size_t>(stack[--top])];
    for (int c = 0; c < kWidth; ++c) {
      if (node.child[c] == Node::kEmpty) continue;
      bool near = true;
      for (int axis = 0; axis < 3; ++axis) {
        near = near && node.low[axis][c] <= high[axis] + distance &&
               node.high[axis][c] >= low[axis] - distance;
      }
      if (!near) continue;
      if (node.child[c] < 0) {
        visit(~node.child[c]);
      } else {
        stack[top++] = node.child[c];
      }
    }
  }
}

}  // namespace swept::offset
