// Samples chosen (face, placement) pairs, batch by batch, into one set of marked edges.
// In: pairs. Out: marked edges.
// Memory: the crossings of one batch (bounded) and the marked edges so far, never all raw
//        crossings.
// Promise: the result depends only on the pairs.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "grid/crossing_records.h"
#include "sampling/sampler.h"

namespace swept::dense {

class PairSampler {
 public:
  PairSampler(const SamplerInput& input, RunContext& run);

  /// Adds the placements [begin, end) of one face. The list must stay valid until the next flush().
  void add(std::uint32_t face, const std::uint32_t* begin, const std::uint32_t* end);
  /// Adds all faces at one placement.
  void addWhole(std::uint32_t placement);
  /// Samples all pairs added so far.
  void flush();

  const MarkedEdges& marked() const { return marked_; }
  MarkedEdges take() { return std::move(marked_); }
  std::int64_t pairs() const { return pairs_; }
  /// Returns the number of raw crossings of all pairs, before those on one edge are merged.
  std::int64_t crossings() const { return crossings_; }
  /// Returns the expected number of crossings of a face at one placement. A batch has about
  /// kBatchWork crossings; each takes 12 bytes, and 24 bytes while they are sorted.
  double workOf(std::uint32_t face) const;
  static constexpr double kBatchWork = 24e6;

 private:
  struct Item {
    std::uint32_t face;
    const std::uint32_t* begin;
    const std::uint32_t* end;
  };
  void sampleItem(const Item& item, RecordChunk& chunk) const;
  void carryOver(std::vector<RecordChunk>& chunks);

  const SamplerInput& input_;
  RunContext& run_;
  std::vector<Placement> placements_;  // from body coordinates (mm) to grid coordinates (cells)
  // 0, 1, 2 ...: each entry serves as a list of one placement.
  std::vector<std::uint32_t> identity_;
  std::vector<Item> items_;
  MarkedEdges marked_;
  std::int64_t pairs_ = 0, crossings_ = 0;
};

}  // namespace swept::dense
