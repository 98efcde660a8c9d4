// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/half_edges.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <atomic>
#include <string>

namespace swept {
namespace {

constexpr std::size_t kGrain = 1 << 14;
using Range = tbb::blocked_range<std::size_t>;

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

EdgeTable::EdgeTable(const Triangles& triangles, std::size_t vertexCount) {
  // 32-bit half-edge numbers: 1.4 thousand million triangles, far above any memory budget.
  if (triangles.size() > 0xffffffffu / 3) {
    throw Error(Status::ResourceLimit, "TooManyTriangles",
                std::to_string(triangles.size()) + " triangles; at most 1431655765 can be handled");
  }
  start_.assign(vertexCount + 1, 0);
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
  tbb::parallel_for(Range(0, vertexCount, kGrain), [&](const Range& range) {
    for (std::size_t v = range.begin(); v != range.end(); ++v) {
      sortGroup(records_.data() + start_[v], records_.data() + start_[v + 1]);
    }
  });
}

Adjacency findAdjacency(const EdgeTable& edges) {
  Adjacency found;
  RawArray<std::uint32_t> across(edges.records().size());
  tbb::parallel_for(Range(0, across.size(), kGrain), [&](const Range& range) {
    std::fill(across.data() + range.begin(), across.data() + range.end(), kNoNeighbour);
  });
  const auto join = [&](const Range& range, EdgeFaults faults) {
    edges.forEachEdge(
        static_cast<std::int64_t>(range.begin()), static_cast<std::int64_t>(range.end()),
        [&](std::int32_t, std::int32_t, const std::uint64_t* first, const std::uint64_t* last) {
          const std::int64_t n = last - first;
          if (n == 2) {
            const auto h = static_cast<std::uint32_t>(EdgeTable::halfEdge(first[0]));
            const auto g = static_cast<std::uint32_t>(EdgeTable::halfEdge(first[1]));
            across[h] = g;
            across[g] = h;
            faults.misoriented += EdgeTable::ascending(first[0]) == EdgeTable::ascending(first[1]);
            return;
          }
          faults.open += n == 1;
          faults.nonManifold += n > 2;
          faults.odd += n % 2;
          faults.misoriented += n > 2 && 2 * std::count_if(first, last, EdgeTable::ascending) != n;
        });
    return faults;
  };
  found.faults =
      tbb::parallel_reduce(Range(0, static_cast<std::size_t>(edges.vertexCount()), kGrain),
                           EdgeFaults{}, join, [](const EdgeFaults& a, const EdgeFaults& b) {
                             return EdgeFaults{a.open + b.open, a.nonManifold + b.nonManifold,
                                               a.odd + b.odd, a.misoriented + b.misoriented};
                           });
  found.across = std::move(across);
  return found;
}

Adjacency findAdjacency(const TriMesh& mesh) { return findAdjacency(EdgeTable(mesh)); }

ListsByKey halfEdgesByVertex(const TriMesh& mesh) {
  return ListsByKey(mesh.vertices.size(), [&](const auto& use) {
    tbb::parallel_for(Range(0, mesh.triangles.size(), kGrain), [&](const Range& range) {
      for (std::size_t h = 3 * range.begin(); h != 3 * range.end(); ++h) {
        use(static_cast<std::size_t>(mesh.triangles[h / 3][h % 3]), static_cast<std::uint32_t>(h));
      }
    });
  });
}

}  // namespace swept
