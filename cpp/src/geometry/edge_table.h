// All half-edges of a triangle list, grouped by undirected edge.
// In:    triangles with indices inside [0, vertexCount).
// Out:   one 64-bit record a half-edge, grouped by its smaller vertex, sorted within the group.
// Cost:  O(n) time, 8 bytes a half-edge + 4 a vertex; counting sort, no hashing.
// Invariants: the order depends on the triangles alone, never on threads.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/raw_array.h"

namespace swept {

/// Half-edge h = 3 * triangle + k runs from corner k to corner k + 1 (mod 3) of its triangle.
class EdgeTable {
 public:
  EdgeTable(const std::vector<std::array<std::int32_t, 3>>& triangles, std::int64_t vertexCount);

  std::int64_t vertexCount() const { return static_cast<std::int64_t>(start_.size()) - 1; }
  /// Records of edges whose smaller vertex is `low`: [begin(low), begin(low + 1)) of records().
  std::int64_t begin(std::int64_t low) const { return start_[static_cast<std::size_t>(low)]; }
  const RawArray<std::uint64_t>& records() const { return records_; }

  static std::int32_t high(std::uint64_t record) { return static_cast<std::int32_t>(record >> 33); }
  /// True if the half-edge runs from the smaller to the larger vertex.
  static bool ascending(std::uint64_t record) { return ((record >> 32) & 1u) == 0; }
  static std::int64_t halfEdge(std::uint64_t record) {
    return static_cast<std::int64_t>(record & 0xffffffffu);
  }

  /// Calls visit(low, high, first, last) for each undirected edge whose smaller vertex lies in
  /// [lowBegin, lowEnd); [first, last) are its records, ascending ones first.
  template <class Visit>
  void forEachEdge(std::int64_t lowBegin, std::int64_t lowEnd, Visit&& visit) const {
    const std::uint64_t* data = records_.data();
    for (std::int64_t low = lowBegin; low < lowEnd; ++low) {
      const std::uint64_t* first = data + begin(low);
      const std::uint64_t* end = data + begin(low + 1);
      while (first != end) {
        const std::uint64_t* last = first + 1;
        while (last != end && high(*last) == high(*first)) ++last;
        visit(static_cast<std::int32_t>(low), high(*first), first, last);
        first = last;
      }
    }
  }

 private:
  std::vector<std::uint32_t> start_;
  RawArray<std::uint64_t> records_;
};

constexpr std::uint32_t kNoNeighbour = 0xffffffffu;

/// Half-edge on the other side of each half-edge where the edge has two triangles, else
/// kNoNeighbour.
RawArray<std::uint32_t> findAcross(const std::vector<std::array<std::int32_t, 3>>& triangles,
                                   std::int64_t vertexCount);

}  // namespace swept
