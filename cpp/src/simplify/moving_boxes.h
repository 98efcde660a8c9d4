// A bounding volume hierarchy of triangles that change. It finds the triangles that a given
// triangle may intersect.
// In:      a mesh and the triangles to find.
// Method:  The tree is built once, with four children per node along a Morton curve. Its boxes grow
// with the triangles, which move only a little. It is rebuilt when half of the triangles are
// removed. (The trees of geometry/nearest_triangle.h and geometry/box_tree.h cannot change.)
// Cost:    O(n log n) to build, O(log n) per change or search.
// Promise: The result does not depend on the number of threads.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "swept/types.h"

namespace swept {

class MovingBoxes {
 public:
  using Box = Eigen::AlignedBox3d;

  /// `members`: triangles in ascending order. The mesh must outlive the tree.
  MovingBoxes(const TriMesh& mesh, std::vector<std::int32_t> members);

  /// Call this after the vertices of a member have changed.
  void grow(std::int32_t triangle);
  void remove(std::int32_t triangle);

  static Box boxOf(const TriMesh& mesh, std::int32_t triangle) {
    const auto& c = mesh.triangles[triangle];
    Box box(mesh.vertices[c[0]]);
    return box.extend(mesh.vertices[c[1]]).extend(mesh.vertices[c[2]]);
  }

  /// Calls visit(triangle, its box) for each member whose box intersects `box`.
  template <class Visit>
  void forBox(const Box& box, const Visit& visit) const {
    std::array<std::pair<std::int32_t, std::uint32_t>, 128> stack;
    int size = 0;
    if (!levels_.empty()) stack[size++] = {static_cast<std::int32_t>(levels_.size()) - 1, 0};
    while (size > 0) {
      const auto [level, index] = stack[--size];
      const std::size_t begin = std::size_t{4} * index;
      const std::size_t all = level == 0 ? order_.size() : levels_[level - 1].size();
      const std::size_t end = begin + 4 < all ? begin + 4 : all;
      for (std::size_t c = begin; c < end; ++c) {
        if (level > 0) {
          if (levels_[level - 1][c].intersects(box))
            stack[size++] = {level - 1, static_cast<std::uint32_t>(c)};
        } else if (order_[c] >= 0) {
          const Box own = boxOf(mesh_, order_[c]);
          if (own.intersects(box)) visit(order_[c], own);
        }
      }
    }
  }

 private:
  void build();
  std::size_t memberOf(std::int32_t triangle) const;

  const TriMesh& mesh_;
  /// In ascending order. Removed triangles stay in the list until the next build().
  std::vector<std::int32_t> members_;
  std::vector<std::uint32_t> slot_;       ///< for each member, its index in order_
  std::vector<std::int32_t> order_;       ///< triangles along the Morton curve; -1: removed
  std::vector<std::vector<Box>> levels_;  ///< levels_[0]: boxes of four triangles each
  std::size_t left_ = 0;
};

}  // namespace swept
