// Raw crossings of any sampler -> marked edges, sorted layer by layer.
// In: chunks of records, in any order. Out: marked edges that depend on the contents of the chunks
// only. Cost: O(crossings); 12 bytes per crossing, and the same again for the records of one work
// item.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "grid/grid_plan.h"
#include "grid/marked_edges.h"
#include "swept/run_context.h"

namespace swept {

/// One crossing. key = i:13 | axis:2 | j:13 | k:13 | fraction:23, from the highest bit down.
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

/// The crossings of one work item and the elements that they refer to (by index within the item).
struct RecordChunk {
  std::vector<CrossingRecord> records;
  std::vector<SweptElement> elements;
  std::vector<std::uint32_t> layerStart;  ///< once ordered: per layer its first record, and the end

  /// Adds an element unless it crosses no lattice edge: rasterise(emit) calls emit(axis, i, j, k,
  /// fraction) for each that it crosses.
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

/// Orders the records by layer, in an array of exactly their number. `room` receives the previous
/// array, emptied, for the next chunk.
void orderByLayer(RecordChunk& chunk, const GridPlan& grid, std::vector<CrossingRecord>& room);

/// Keeps only those crossings of every lattice edge that sortRecords() would select, in any order.
void keepEnds(std::vector<CrossingRecord>& records, const GridPlan& grid);

/// Consumes the chunks. The result does not depend on which thread made which chunk.
MarkedEdges sortRecords(std::vector<RecordChunk>& chunks, const GridPlan& grid, RunContext& run);

}  // namespace swept
