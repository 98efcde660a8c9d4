// The part of a surface near some of its triangles, selected by blocks of cells.
// Cost: one bit per block of the grid, and one number per triangle, valid as long as the triangle's
// first corner stays where it is.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "contour/surface.h"

namespace swept {

/// The block that contains each triangle's first corner.
class TriangleBlocks {
 public:
  TriangleBlocks(const TriMesh& mesh, const GridPlan& plan);
  /// To be called after triangles or their corners have changed, or triangles were added.
  void update(const TriMesh& mesh, const std::vector<std::int32_t>& changed);

 private:
  friend class BlockSet;
  static constexpr int kBlockCells = 4;
  Eigen::Vector3i cellOf(const Eigen::Vector3d& x) const;
  std::size_t number(const Eigen::Vector3i& block) const {
    return (static_cast<std::size_t>(block[0]) * size_[1] + block[1]) * size_[2] + block[2];
  }
  std::uint32_t blockOf(const TriMesh& mesh, std::size_t triangle) const;

  GridPlan plan_;
  Eigen::Vector3i size_;
  std::vector<std::uint32_t> of_;
};

class BlockSet {
 public:
  explicit BlockSet(const TriangleBlocks& blocks);
  /// Adds all blocks within `reach` cells of the triangle's box. Safe to call from many threads.
  void add(const TriMesh& mesh, std::int32_t triangle, int reach);
  /// Whether the triangle's first corner lies in one of the blocks.
  bool contains(std::size_t triangle) const {
    const std::uint32_t block = blocks_.of_[triangle];
    return (bits_[block >> 6] >> (block & 63) & 1u) != 0;
  }
  /// The triangles of the surface, or of `among` if given, that the blocks contain; in rising order
  /// if `among` is.
  std::vector<std::int32_t> triangles(const std::vector<std::int32_t>* among = nullptr) const;

 private:
  const TriangleBlocks& blocks_;
  std::vector<std::uint64_t> bits_;
};

/// Concatenates what use(n, part) appends for n in [0, count), in the order of n.
template <class T, class Use>
std::vector<T> gather(std::size_t count, const Use& use) {
  constexpr std::size_t kBlock = 1 << 15;
  std::vector<std::vector<T>> parts(count / kBlock + 1);
  parallelBlocks(count, kBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) use(n, parts[begin / kBlock]);
  });
  if (parts.size() == 1) return std::move(parts[0]);
  std::vector<T> out;
  for (const auto& part : parts) out.insert(out.end(), part.begin(), part.end());
  return out;
}

}  // namespace swept
