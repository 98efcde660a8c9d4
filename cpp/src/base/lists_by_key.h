// Values grouped by a small integer key, gathered by all cores.
// In:    a walk over all (key, value) pairs, which is made twice and may run in parallel.
// Out:   per key its values, in rising order where that is asked for, whoever put them in.
// Cost:  4 bytes a key and the size of a value.
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
  /// forAll(use) calls use(key, value) for every pair, keys in [0, keys).
  template <class ForAll>
  ListsByKey(std::size_t keys, const ForAll& forAll) : start_(keys + 1, 0) {
    forAll([&](std::size_t key, const Value&) {
      std::atomic_ref<std::uint32_t>(start_[key]).fetch_add(1, std::memory_order_relaxed);
    });
    // Inclusive sums; the fill counts each list down to its start.
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
  /// The values of a key in rising order. Different keys may be asked for at once.
  std::span<const Value> of(std::size_t key) {
    const std::span<Value> list(values_.data() + start_[key], start_[key + 1] - start_[key]);
    std::sort(list.begin(), list.end());
    return list;
  }
  /// The values of a key: in rising order if of() was called for it, else in any.
  std::span<const Value> asTheyStand(std::size_t key) const {
    return {values_.data() + start_[key], start_[key + 1] - start_[key]};
  }

 private:
  std::vector<std::uint32_t> start_{0};
  RawArray<Value> values_;
};

}  // namespace swept
