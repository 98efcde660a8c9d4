// Union-find that many threads may join at once (Anderson, Woll 1991; path halving).
// Each set is a tree of links to smaller numbers; its root is its smallest member, in whatever
// order the sets were joined. Numbers are indices of members.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace swept {

/// Every member in a set of its own.
template <class Number>
std::vector<Number> singleSets(std::size_t members) {
  std::vector<Number> parent(members);
  std::iota(parent.begin(), parent.end(), Number{0});
  return parent;
}

template <class Number>
Number findRoot(std::vector<Number>& parent, Number i) {
  for (;;) {
    const Number p = std::atomic_ref<Number>(parent[i]).load(std::memory_order_relaxed);
    if (p == i) return i;
    const Number q = std::atomic_ref<Number>(parent[p]).load(std::memory_order_relaxed);
    if (q != p) std::atomic_ref<Number>(parent[i]).store(q, std::memory_order_relaxed);
    i = q;
  }
}

/// Links the larger root below the smaller one, so that the final roots do not depend on the order.
template <class Number>
void unite(std::vector<Number>& parent, Number a, Number b) {
  for (;;) {
    a = findRoot(parent, a);
    b = findRoot(parent, b);
    if (a == b) return;
    if (a > b) std::swap(a, b);
    Number expected = b;
    if (std::atomic_ref<Number>(parent[b]).compare_exchange_strong(expected, a,
                                                                   std::memory_order_relaxed)) {
      return;
    }
  }
}

}  // namespace swept
