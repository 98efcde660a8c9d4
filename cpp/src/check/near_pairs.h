// Pairs of triangles that meet, where only few triangles can be one side of a pair.
// In:    a mesh, a frame of cubes about as large as its triangles, the numbers of the few
//        ("members") and of those that they may meet.
// Out:   every pair with at least one member that meets where it should not, exactly as
//        findSelfIntersections() counts them.
// Cost:  O(cells covered by members) to build, O(cells covered) a question. No tree: the cells of
//        the members' boxes are hashed, and a bit per hash answers most questions.
// Invariants: the same pairs in the same order for any number of threads.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "check/self_intersections.h"
#include "swept/run_context.h"
#include "swept/types.h"

namespace swept {

struct CellFrame {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  double cell = 1;
};

class NearPairs {
 public:
  /// `mesh` must outlive this and stay as it is; no vertex may lie below the frame's origin by more
  /// than a cell, nor 2^20 cells above.
  NearPairs(const TriMesh& mesh, const CellFrame& frame, std::vector<std::int32_t> members,
            RunContext& run);

  /// False if no member's box reaches into this cell.
  bool reaches(int i, int j, int k) const { return bit(keyOf(i, j, k)); }

  /// `others` may hold members; a pair of two members is found if both are in `others`.
  SelfIntersections find(const std::vector<std::int32_t>& others) const;

 private:
  struct Box {
    Eigen::Vector3d low, high;
    Eigen::Vector3i lowCell, highCell;
  };
  struct Entry {
    std::uint64_t key;
    std::uint32_t member;
  };
  using Pairs = std::vector<std::pair<std::int32_t, std::int32_t>>;

  static std::uint64_t keyOf(int i, int j, int k) {
    return static_cast<std::uint64_t>(i + 2) << 42 | static_cast<std::uint64_t>(j + 2) << 21 |
           static_cast<std::uint64_t>(k + 2);
  }
  static std::uint64_t hashOf(std::uint64_t key) { return key * 0x9e3779b97f4a7c15u; }
  bool bit(std::uint64_t key) const {
    const std::uint64_t h = hashOf(key) >> bitShift_;
    return (bits_[h >> 6] >> (h & 63) & 1u) != 0;
  }
  Box boxOf(std::int32_t triangle) const;
  void ask(std::int32_t triangle, Pairs& out) const;

  const TriMesh& mesh_;
  CellFrame frame_;
  RunContext& run_;
  std::vector<std::int32_t> members_;
  std::vector<std::uint8_t> isMember_;  // by triangle
  std::vector<Box> boxes_;              // by member
  std::vector<std::uint32_t> start_;    // by bucket
  std::vector<Entry> entries_;
  std::vector<std::uint64_t> bits_;
  int bitShift_ = 63, bucketShift_ = 63;
};

}  // namespace swept
