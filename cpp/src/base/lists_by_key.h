// Numbers grouped by a small integer key, gathered by all cores.
// In:    a walk over all (key, value) pairs, which is made twice and may run in parallel.
// Out:   per key its values in rising order, whoever put them in.
// Cost:  4 bytes a key and a value; a list is sorted when it is asked for.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

namespace swept {

class ListsByKey {
 public:
  /// forAll(use) calls use(key, value) for every pair, keys in [0, keys).
  template <class ForAll>
  ListsByKey(std::size_t keys, const ForAll& forAll) : start_(keys + 1, 0) {
    forAll([&](std::size_t key, std::uint32_t) {
      std::atomic_ref<std::uint32_t>(start_[key]).fetch_add(1, std::memory_order_relaxed);
    });
    // Inclusive sums; the fill counts each list down to its start.
    std::uint32_t sum = 0;
    for (std::uint32_t& value : start_) value = sum += value;
    values_.resize(sum);
    forAll([&](std::size_t key, std::uint32_t value) {
      const std::atomic_ref<std::uint32_t> next(start_[key]);
      values_[next.fetch_sub(1, std::memory_order_relaxed) - 1] = value;
    });
  }

  /// Different keys may be asked for at once.
  std::span<const std::uint32_t> of(std::size_t key) {
    const std::span<std::uint32_t> list(values_.data() + start_[key],
                                        start_[key + 1] - start_[key]);
    std::sort(list.begin(), list.end());
    return list;
  }

 private:
  std::vector<std::uint32_t> start_;
  std::vector<std::uint32_t> values_;
};

}  // namespace swept
