// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sampling/cpu/sample_cache.h"

#include <bit>

namespace swept {

SampleCache::Key SampleCache::keyOf(const SamplerInput& input, std::size_t placement) {
  Key key{};
  std::size_t n = 0;
  for (int axis = 0; axis < 3; ++axis) {
    key[n++] = input.grid.origin[axis];
    key[n++] = input.grid.points[axis];
  }
  key[n++] = input.cull ? input.grid.cell : -input.grid.cell;
  for (int step = -1; step <= 1; ++step) {
    // At the ends of the motion one neighbour is missing. Zeros replace it in the key; no rotation
    // matrix has only zeros.
    const bool exists =
        !(step < 0 && placement == 0) &&
        placement + static_cast<std::size_t>(step + 1) <= input.motion.placements.size();
    if (!exists) {
      n += 12;
      continue;
    }
    const Placement& p = input.motion.placements[placement + static_cast<std::size_t>(step)];
    for (int e = 0; e < 9; ++e) key[n++] = p.rotation(e / 3, e % 3);
    for (int e = 0; e < 3; ++e) key[n++] = p.translation[e];
  }
  return key;
}

std::size_t SampleCache::Hash::operator()(const Key& key) const {
  std::uint64_t h = 0;
  for (const double x : key) h = (h ^ std::bit_cast<std::uint64_t>(x)) * 0x9e3779b97f4a7c15u;
  return h ^ h >> 32;
}

bool SampleCache::find(const Key& key, std::size_t placement, RecordChunk& out) const {
  const auto at = chunks_.find(key);
  if (at == chunks_.end()) return false;
  out = at->second;
  for (SweptElement& e : out.elements) e.placement = static_cast<std::uint32_t>(placement);
  return true;
}

void SampleCache::replace(const std::vector<Key>& keys, const std::vector<RecordChunk>& chunks) {
  std::size_t bytes = 0;
  for (const RecordChunk& chunk : chunks) {
    bytes += chunk.records.size() * sizeof(CrossingRecord) +
             chunk.elements.size() * sizeof(SweptElement);
  }
  std::unordered_map<Key, RecordChunk, Hash> next;
  for (std::size_t k = 0; k < keys.size() && bytes <= kMaxBytes; ++k) {
    const auto known = chunks_.find(keys[k]);
    // Move known chunks instead of copying them: a chunk may take a megabyte.
    next.try_emplace(keys[k], known != chunks_.end() ? std::move(known->second) : chunks[k]);
  }
  chunks_ = std::move(next);
}

}  // namespace swept
