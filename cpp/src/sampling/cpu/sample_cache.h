// Keeps the crossings of each step of a continuous motion for the next run with the same body.
// After a change of a few poses, only the steps near them are sampled again.
// The crossings of a step depend on the grid, on culling and on three placements: the one before
// (culling uses its direction), its own and the next. The key contains their exact numbers.
// Memory: the chunks of the last run, up to kMaxBytes. Not safe for several threads at a time.
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
  // A motion with more crossings is not cached. A preview at 64 to 128 cells takes far less.
  static constexpr std::size_t kMaxBytes = 256u << 20;

  using Key = std::array<double, 43>;
  static Key keyOf(const SamplerInput& input, std::size_t placement);

  /// Copies the chunk of this key, with its elements moved to `placement`. Returns false if the key
  /// is not known.
  bool find(const Key& key, std::size_t placement, RecordChunk& out) const;
  /// Replaces the contents: chunks[k] holds the crossings for keys[k].
  void replace(const std::vector<Key>& keys, const std::vector<RecordChunk>& chunks);

  void clear() { chunks_.clear(); }

  std::int64_t hits() const { return hits_; }  ///< number of known steps in all runs
  void countHit() { ++hits_; }

 private:
  struct Hash {
    std::size_t operator()(const Key& key) const;
  };
  std::unordered_map<Key, RecordChunk, Hash> chunks_;
  std::int64_t hits_ = 0;
};

}  // namespace swept
