// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/edge_table.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <string>

#include "swept/types.h"

namespace swept {
namespace {

constexpr std::size_t kGrain = 1 << 14;

void sortGroup(std::uint64_t* first, std::uint64_t* last) {
  if (last - first > 24) {
    std::sort(first, last);
    return;
  }
  for (std::uint64_t* i = first; i != last; ++i) {
    const std::uint64_t value = *i;
    std::uint64_t* hole = i;
    for (; hole != first && *(hole - 1) > value; --hole) *hole = *(hole - 1);
    *hole = value;
  }
}

}  // namespace

EdgeTable::EdgeTable(const std::vector<std::array<std::int32_t, 3>>& triangles,
                     std::int64_t vertexCount) {
  // 32-bit half-edge numbers: 1.4 thousand million triangles, far above any memory budget.
  if (triangles.size() > 0xffffffffu / 3) {
    throw Error(Status::ResourceLimit, "TooManyTriangles",
                std::to_string(triangles.size()) + " triangles; at most 1431655765 can be handled");
  }
  using Range = tbb::blocked_range<std::size_t>;
  start_.assign(static_cast<std::size_t>(vertexCount) + 1, 0);
  // Atomic counters: the order in which a group fills varies, its sorted content does not.
  tbb::parallel_for(Range(0, triangles.size(), kGrain), [&](const Range& range) {
    for (std::size_t t = range.begin(); t != range.end(); ++t) {
      const auto& tri = triangles[t];
      for (int k = 0; k < 3; ++k) {
        const auto low = static_cast<std::size_t>(std::min(tri[k], tri[(k + 1) % 3]));
        std::atomic_ref<std::uint32_t>(start_[low]).fetch_add(1, std::memory_order_relaxed);
      }
    }
  });
  // Inclusive sums; the fill below counts each entry down to the start of its group.
  std::uint32_t sum = 0;
  for (auto& value : start_) {
    sum += value;
    value = sum;
  }
  records_ = RawArray<std::uint64_t>(3 * triangles.size());
  tbb::parallel_for(Range(0, triangles.size(), kGrain), [&](const Range& range) {
    for (std::size_t t = range.begin(); t != range.end(); ++t) {
      const auto& tri = triangles[t];
      for (int k = 0; k < 3; ++k) {
        const std::int32_t a = tri[k];
        const std::int32_t b = tri[(k + 1) % 3];
        const std::uint64_t descending = a < b ? 0 : 1;
        const auto low = static_cast<std::size_t>(std::min(a, b));
        const std::uint32_t slot =
            std::atomic_ref<std::uint32_t>(start_[low]).fetch_sub(1, std::memory_order_relaxed) - 1;
        records_[slot] = (static_cast<std::uint64_t>(std::max(a, b)) << 33) | (descending << 32) |
                         (3 * t + static_cast<std::size_t>(k));
      }
    }
  });
  const auto count = static_cast<std::size_t>(vertexCount);
  tbb::parallel_for(Range(0, count, kGrain), [&](const Range& range) {
    for (std::size_t v = range.begin(); v != range.end(); ++v) {
      sortGroup(records_.data() + start_[v], records_.data() + start_[v + 1]);
    }
  });
}

RawArray<std::uint32_t> findAcross(const std::vector<std::array<std::int32_t, 3>>& triangles,
                                   std::int64_t vertexCount) {
  const EdgeTable edges(triangles, vertexCount);
  RawArray<std::uint32_t> across(3 * triangles.size());
  std::fill(across.data(), across.data() + across.size(), kNoNeighbour);
  edges.forEachEdge(
      0, vertexCount,
      [&](std::int32_t, std::int32_t, const std::uint64_t* first, const std::uint64_t* last) {
        if (last - first != 2) return;
        const auto h = static_cast<std::uint32_t>(EdgeTable::halfEdge(first[0]));
        const auto g = static_cast<std::uint32_t>(EdgeTable::halfEdge(first[1]));
        across[h] = g;
        across[g] = h;
      });
  return across;
}

}  // namespace swept
