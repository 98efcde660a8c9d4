// Crossings of the steps of a continuous motion, kept from one run to the next of the same body: a
// motion of which few poses change is sampled again near these only.
// What a step's elements give depends on the grid, on culling and on three placements: the one
// before (its direction culls), its own, and the next. These are compared to the last bit.
// Memory: what the last run sampled, up to kMaxBytes. Not for several threads at a time.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>

#include "grid/crossing_records.h"
#include "sampling/sampler.h"

namespace swept {

class SampleCache {
 public:
  static constexpr std::size_t kMaxBytes = 256u << 20;

  using Key = std::array<double, 43>;
  static Key keyOf(const SamplerInput& input, std::size_t placement);

  /// The chunk of this key with its elements moved to `placement`; false if it is not known.
  bool find(const Key& key, std::size_t placement, RecordChunk& out) const;
  /// Forgets everything but these: chunks[k] is what key k gives.
  void replace(const std::vector<Key>& keys, const std::vector<RecordChunk>& chunks);

  void clear() { chunks_.clear(); }

  std::int64_t hits() const { return hits_; }  ///< steps of all runs that were known
  void countHit() { ++hits_; }

 private:
  struct Hash {
    std::size_t operator()(const Key& key) const;
  };
  std::unordered_map<Key, RecordChunk, Hash> chunks_;
  std::int64_t hits_ = 0;
};

}  // namespace swept
