// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/half_edges.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <string>

#include "base/parallel.h"

namespace swept {
namespace {

constexpr std::size_t kEdgeGrain = 1 << 14;
using Range = tbb::blocked_range<std::size_t>;

}  // namespace

EdgeTable::EdgeTable(const Triangles& triangles, std::size_t vertexCount) {
  // 32-bit half-edge numbers allow 1,431,655,765 triangles, far above any memory budget.
  if (triangles.size() > 0xffffffffu / 3) {
    throw Error(Status::ResourceLimit, "TooManyTriangles",
                "the mesh has " + std::to_string(triangles.size()) +
                    " triangles, but the limit is 1431655765; use a coarser mesh");
  }
  const auto forAll = [&](const auto& use) {
    parallelBlocks(triangles.size(), kEdgeGrain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t t = begin; t < end; ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
          const std::int32_t a = triangles[t][k], b = triangles[t][(k + 1) % 3];
          const std::uint64_t descending = a < b ? 0 : 1;
          use(static_cast<std::size_t>(std::min(a, b)),
              static_cast<std::uint64_t>(std::max(a, b)) << 33 | descending << 32 | (3 * t + k));
        }
      }
    });
  };
  groups_ = ListsByKey<std::uint64_t>(vertexCount, forAll);
  parallelBlocks(vertexCount, kEdgeGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) groups_.of(v);
  });
}

Adjacency findAdjacency(const EdgeTable& edges) {
  Adjacency found;
  RawArray<std::uint32_t> across(edges.records().size());
  parallelBlocks(across.size(), kEdgeGrain, [&](std::size_t begin, std::size_t end) {
    std::fill(across.data() + begin, across.data() + end, kNoNeighbour);
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
      tbb::parallel_reduce(Range(0, static_cast<std::size_t>(edges.vertexCount()), kEdgeGrain),
                           EdgeFaults{}, join, [](const EdgeFaults& a, const EdgeFaults& b) {
                             return EdgeFaults{a.open + b.open, a.nonManifold + b.nonManifold,
                                               a.odd + b.odd, a.misoriented + b.misoriented};
                           });
  found.across = std::move(across);
  return found;
}

Adjacency findAdjacency(const TriMesh& mesh) { return findAdjacency(EdgeTable(mesh)); }

ListsByKey<> halfEdgesByVertex(const TriMesh& mesh) {
  return ListsByKey<>(mesh.vertices.size(), [&](const auto& use) {
    parallelBlocks(mesh.triangles.size(), kEdgeGrain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t h = 3 * begin; h != 3 * end; ++h) {
        use(static_cast<std::size_t>(mesh.triangles[h / 3][h % 3]), static_cast<std::uint32_t>(h));
      }
    });
  });
}

}  // namespace swept
