// Keeps the crossings of each step of a continuous motion for the next run with the same body.
// After a change of a few poses, only the steps near them are sampled again.
// The crossings of a step depend on the grid, on culling and on three placements: its own, the one
// before it (for culling by direction) and the one after it. The key contains the exact values of
// all these.
// Memory: the chunks of the previous run, up to kMaxBytes. Not safe for several threads at a time.
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
  // Motions with more crossings are not cached. A preview at 64 to 128 cells takes far less.
  static constexpr std::size_t kMaxBytes = 256u << 20;

  using Key = std::array<double, 43>;
  static Key keyOf(const SamplerInput& input, std::size_t placement);

  /// Copies the chunk with this key to `out`, and sets the placement of its elements to
  /// `placement`. Returns false if the key is unknown.
  bool find(const Key& key, std::size_t placement, RecordChunk& out) const;
  /// Replaces the contents: chunks[k] holds the crossings for keys[k].
  void replace(const std::vector<Key>& keys, const std::vector<RecordChunk>& chunks);

  void clear() { chunks_.clear(); }

  /// Number of steps found in the cache, over all runs.
  std::int64_t hits() const { return hits_; }
  void countHit() { ++hits_; }

 private:
  struct Hash {
    std::size_t operator()(const Key& key) const;
  };
  std::unordered_map<Key, RecordChunk, Hash> chunks_;
  std::int64_t hits_ = 0;
};

}  // namespace swept
