// Pairs of triangles that meet, where only few triangles can be one side of a pair.
// In:    a mesh, a frame of cubes about as large as its triangles, the numbers of the few
//        ("members") and of those that they may meet.
// Out:   every pair with at least one member that meets where it should not, exactly as
//        findSelfIntersections() counts them.
// Cost:  O(members) to build, O(neighbours) a question. No tree: blocks of cells are hashed whole,
// so
//        that what is near in space is near in memory, and a bit per cell answers most questions.
// Invariants: the same pairs in the same order for any number of threads.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/raw_array.h"
#include "geometry/self_intersections.h"
#include "swept/run_context.h"
#include "swept/types.h"

namespace swept {

struct CellFrame {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  double cell = 1;
};

/// Do two triangles with area meet where they should not?
bool meetWrongly(const TriMesh& mesh, std::int32_t first, std::int32_t second);

class NearPairs {
 public:
  /// `mesh` must outlive this and stay as it is; no vertex may lie below the frame's origin by more
  /// than a cell, nor 2^20 cells above.
  NearPairs(const TriMesh& mesh, const CellFrame& frame, const std::vector<std::int32_t>& members,
            RunContext& run);

  /// False if no member's box reaches into this cell.
  bool reaches(int i, int j, int k) const { return bit(keyOf(i, j, k)); }

  /// `others` may hold members; a pair of two members is found if both are in `others`.
  SelfIntersections find(const std::vector<std::int32_t>& others) const;

 private:
  /// Box of a member in cells of the frame, rounded outward.
  struct Box {
    std::array<float, 3> low, high;
    std::int32_t triangle;
    bool meets(const Box& other) const {
      return low[0] <= other.high[0] && other.low[0] <= high[0] && low[1] <= other.high[1] &&
             other.low[1] <= high[1] && low[2] <= other.high[2] && other.low[2] <= high[2];
    }
  };
  struct CellRange {
    Eigen::Vector3i low, high;
  };
  /// One member in one brick of 2 x 2 x 2 cells. `above`: a bit per axis if the member's box begins
  /// before this brick.
  struct Entry {
    std::uint64_t key;
    std::uint32_t member, above;
  };
  /// Where a cell or a brick is found: a block of 4 x 4 x 4 cells takes one slot.
  struct Place {
    std::uint64_t slot;
    unsigned cell;
  };
  using Pairs = std::vector<std::pair<std::int32_t, std::int32_t>>;

  static std::uint64_t keyOf(int i, int j, int k) {
    return static_cast<std::uint64_t>(i + 2) << 42 | static_cast<std::uint64_t>(j + 2) << 21 |
           static_cast<std::uint64_t>(k + 2);
  }
  Place placeOf(std::uint64_t key) const {
    constexpr std::uint64_t kInBlock = std::uint64_t{3} << 42 | std::uint64_t{3} << 21 | 3;
    const std::uint64_t hash = (key & ~kInBlock) * 0x9e3779b97f4a7c15u;
    return {hash >> slotShift_,
            static_cast<unsigned>((key >> 38 & 48) | (key >> 19 & 12) | (key & 3))};
  }
  bool bit(std::uint64_t key) const {
    const Place place = placeOf(key);
    return (bits_[place.slot] >> place.cell & 1u) != 0;
  }
  /// Of a brick, by the key of its lowest cell.
  std::size_t bucketOf(std::uint64_t key) const {
    const Place place = placeOf(key);
    return place.slot << 3 |
           ((place.cell >> 3 & 4) | (place.cell >> 2 & 2) | (place.cell >> 1 & 1));
  }
  Box boxOf(std::int32_t triangle, CellRange& cells) const;
  template <class Visit>
  static void forBricks(const CellRange& cells, const Visit& visit);
  bool anyBit(const CellRange& cells) const;
  void enter(const std::vector<CellRange>& cells);
  void ask(std::int32_t triangle, Pairs& out) const;

  const TriMesh& mesh_;
  CellFrame frame_;
  double cellsPerUnit_;
  RunContext& run_;
  std::vector<std::uint8_t> isMember_;  // by triangle
  std::vector<Box> boxes_;              // by member
  std::vector<std::uint32_t> start_;    // by bucket
  RawArray<Entry> entries_;
  std::vector<std::uint64_t> bits_;  // by slot
  int slotShift_ = 63;
};

}  // namespace swept
