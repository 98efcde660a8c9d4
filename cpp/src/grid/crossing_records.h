// Sorts the raw crossings of any sampler into marked edges, layer by layer.
//
// In: chunks of records, in any order. Out: marked edges that depend only on the contents of the
// chunks. Cost: O(crossings) time; 12 bytes per crossing, and another 12 bytes for each crossing of
// the chunks that are being sorted.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "grid/grid_plan.h"
#include "grid/marked_edges.h"
#include "swept/run_context.h"

namespace swept {

/// One crossing. Numbers of bits in `key`, from the highest: i 13, axis 2, j 13, k 13, fraction 23.
struct __attribute__((packed, aligned(4))) CrossingRecord {
  std::uint64_t key;
  std::uint32_t element;

  static constexpr int kFractionBits = 23;
  static CrossingRecord make(int axis, std::int32_t i, std::int32_t j, std::int32_t k,
                             double fraction, std::uint32_t element) {
    const auto f = static_cast<std::uint64_t>(fraction * ((1 << kFractionBits) - 1));
    return {static_cast<std::uint64_t>(i) << 51 | static_cast<std::uint64_t>(axis) << 49 |
                static_cast<std::uint64_t>(j) << 36 | static_cast<std::uint64_t>(k) << 23 | f,
            element};
  }
  std::uint32_t layer() const { return static_cast<std::uint32_t>(key >> 51); }
  std::uint32_t axis() const { return static_cast<std::uint32_t>(key >> 49) & 3u; }
  std::uint32_t column() const { return static_cast<std::uint32_t>(key >> 36) & 0x1fffu; }
  std::uint32_t k() const { return static_cast<std::uint32_t>(key >> 23) & 0x1fffu; }
  float fraction() const {
    return static_cast<float>(static_cast<std::uint32_t>(key) & 0x7fffffu) /
           ((1 << kFractionBits) - 1);
  }
};
static_assert(sizeof(CrossingRecord) == 12);

/// The crossings of one work item. A crossing refers to its element by the index in `elements`.
struct RecordChunk {
  std::vector<CrossingRecord> records;
  std::vector<SweptElement> elements;
  /// Set by orderByLayer(): the first record of each layer, and the end.
  std::vector<std::uint32_t> layerStart;

  /// Adds an element unless it crosses no lattice edge. rasterise(emit) must call emit(axis, i, j,
  /// k, fraction) for each lattice edge that the element crosses.
  template <class Rasterise>
  void add(const SweptElement& element, const Rasterise& rasterise) {
    const auto number = static_cast<std::uint32_t>(elements.size());
    const std::size_t before = records.size();
    rasterise([&](int axis, std::int32_t i, std::int32_t j, std::int32_t k, double fraction) {
      records.push_back(CrossingRecord::make(axis, i, j, k, fraction, number));
    });
    if (records.size() != before) elements.push_back(element);
  }
};

/// Orders the records by layer, in an array without spare capacity. `spare` receives the previous
/// array of the chunk, emptied, so that the next chunk can use it again.
void orderByLayer(RecordChunk& chunk, const GridPlan& grid, std::vector<CrossingRecord>& spare);

/// Keeps only the records that sortRecords() would select on each lattice edge. The records may be
/// in any order.
void keepEnds(std::vector<CrossingRecord>& records, const GridPlan& grid);

/// Turns the chunks into marked edges and empties them. The result does not depend on which thread
/// made which chunk.
MarkedEdges sortRecords(std::vector<RecordChunk>& chunks, const GridPlan& grid, RunContext& run);

}  // namespace swept
