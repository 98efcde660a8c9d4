// Selects the triangles of a surface that are near some given ones, by blocks of cells.
// Memory: one bit per block of the grid, and one block number per triangle. This number is valid as
// long as the first corner of the triangle does not move.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "contour/surface.h"

namespace swept {

/// A triangle spans at most two cells along each axis, so it cannot intersect triangles more than
/// this many cells away.
constexpr int kReachCells = 4;
/// Triangles of one parallel task.
constexpr std::size_t kTrianglesPerTask = 1 << 15;

/// Stores for each triangle the block that contains its first corner.
class TriangleBlocks {
 public:
  TriangleBlocks(const TriMesh& mesh, const GridPlan& plan);
  /// Call this after triangles or their corners have changed, or after triangles were added.
  void update(const TriMesh& mesh, const std::vector<std::int32_t>& changed);
  /// Returns the triangles near the members, in the order of the list that was searched: `among` if
  /// given, otherwise all triangles of the surface. A triangle is near if the block with its first
  /// corner meets the bounding box of some member, enlarged by `reachCells`.
  std::vector<std::int32_t> near(const TriMesh& mesh, const std::vector<std::int32_t>& members,
                                 int reachCells,
                                 const std::vector<std::int32_t>* among = nullptr) const;

 private:
  Eigen::Vector3i cellOf(const Eigen::Vector3d& x) const;
  std::size_t number(const Eigen::Vector3i& block) const {
    return (static_cast<std::size_t>(block[0]) * size_[1] + block[1]) * size_[2] + block[2];
  }
  std::uint32_t blockOf(const TriMesh& mesh, std::size_t triangle) const;

  GridPlan plan_;
  Eigen::Vector3i size_;
  std::vector<std::uint32_t> of_;
};

}  // namespace swept
