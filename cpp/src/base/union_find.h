// Union-find on which many threads may work at once (Anderson, Woll 1991; path halving). Each set
// is a tree whose links lead to smaller indices. Its root is its smallest member, regardless of the
// order in which the sets were united. Members are numbered from 0.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace swept {

/// Returns sets of one member each.
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

/// Unites two sets. The larger root becomes a child of the smaller root, so the final roots do not
/// depend on the order of the calls.
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
