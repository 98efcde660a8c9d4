// Values grouped by an integer key. Several threads may fill the lists at once.
// In:     a function that visits all (key, value) pairs. The constructor calls it twice.
// Out:    the values of each key, sorted on request. The order of the pairs does not matter.
// Memory: 4 bytes per key; per value its own size.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

#include "base/raw_array.h"

namespace swept {

template <class Value = std::uint32_t>
class ListsByKey {
 public:
  ListsByKey() = default;
  /// forAll(use) calls use(key, value) for every pair, with keys in [0, keys), in any order and
  /// from any threads. Both calls must give the same pairs.
  template <class ForAll>
  ListsByKey(std::size_t keys, const ForAll& forAll) : start_(keys + 1, 0) {
    forAll([&](std::size_t key, const Value&) {
      std::atomic_ref<std::uint32_t>(start_[key]).fetch_add(1, std::memory_order_relaxed);
    });
    // After this sum, start_[key] is the end of the list of `key`. The second pass fills each list
    // from its end and so counts start_[key] down to the start of the list.
    std::uint32_t sum = 0;
    for (std::uint32_t& end : start_) end = sum += end;
    values_ = RawArray<Value>(sum);
    forAll([&](std::size_t key, const Value& value) {
      const std::atomic_ref<std::uint32_t> next(start_[key]);
      values_[next.fetch_sub(1, std::memory_order_relaxed) - 1] = value;
    });
  }

  std::size_t keys() const { return start_.size() - 1; }
  const RawArray<Value>& values() const { return values_; }
  /// Sorts the values of a key and returns them. Threads may call it for different keys at once.
  std::span<const Value> of(std::size_t key) {
    const std::span<Value> list(values_.data() + start_[key], start_[key + 1] - start_[key]);
    std::sort(list.begin(), list.end());
    return list;
  }
  /// Returns the values of a key without sorting them. They are in ascending order if of() was
  /// called for this key, otherwise in any order.
  std::span<const Value> asTheyStand(std::size_t key) const {
    return {values_.data() + start_[key], start_[key + 1] - start_[key]};
  }

 private:
  std::vector<std::uint32_t> start_{0};
  RawArray<Value> values_;
};

}  // namespace swept
