// The part of a surface near some of its triangles, chosen by blocks of cells.
// Cost: one pass over the triangles; a bit a block of the grid.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "contour/surface.h"

namespace swept {

class BlockSet {
 public:
  explicit BlockSet(const GridPlan& plan);
  /// All blocks within `reach` cells of the triangle's corners.
  void add(const TriMesh& mesh, std::int32_t triangle, int reach);
  /// Does the triangle's first corner lie in one of the blocks?
  bool holds(const TriMesh& mesh, std::int32_t triangle) const;

 private:
  static constexpr int kBlockCells = 8;
  Eigen::Vector3i cellOf(const Eigen::Vector3d& x) const;
  std::size_t number(const Eigen::Vector3i& block) const {
    return (static_cast<std::size_t>(block[0]) * size_[1] + block[1]) * size_[2] + block[2];
  }

  GridPlan plan_;
  Eigen::Vector3i size_;
  std::vector<bool> blocks_;
};

/// Triangles of the surface, or of `among` if that is given, that the blocks hold; in rising order
/// where `among` rises.
std::vector<std::int32_t> trianglesIn(const BlockSet& blocks, const TriMesh& mesh,
                                      const std::vector<std::int32_t>* among = nullptr);

}  // namespace swept
