// Union-find that many threads may join at once.
// Each set is a tree of links to smaller numbers; its root is its smallest member, in whatever
// order the sets were joined. Begin with parent[i] = i.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <utility>
#include <vector>

namespace swept {

inline std::int32_t findRoot(std::vector<std::int32_t>& parent, std::int32_t i) {
  for (;;) {
    const std::int32_t p = std::atomic_ref<std::int32_t>(parent[i]).load(std::memory_order_relaxed);
    if (p == i) return i;
    const std::int32_t q = std::atomic_ref<std::int32_t>(parent[p]).load(std::memory_order_relaxed);
    if (q != p) std::atomic_ref<std::int32_t>(parent[i]).store(q, std::memory_order_relaxed);
    i = q;
  }
}

/// Links the larger root below the smaller one, so that the final roots do not depend on the order.
inline void unite(std::vector<std::int32_t>& parent, std::int32_t a, std::int32_t b) {
  for (;;) {
    a = findRoot(parent, a);
    b = findRoot(parent, b);
    if (a == b) return;
    if (a > b) std::swap(a, b);
    std::int32_t expected = b;
    if (std::atomic_ref<std::int32_t>(parent[b]).compare_exchange_strong(
            expected, a, std::memory_order_relaxed)) {
      return;
    }
  }
}

}  // namespace swept
