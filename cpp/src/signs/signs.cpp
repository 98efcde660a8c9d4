// SPDX-License-Identifier: LGPL-2.1-or-later
#include "signs/signs.h"

#include <algorithm>
#include <span>

#include "base/parallel.h"
#include "swept/types.h"

namespace swept {
namespace {

using Edges = std::span<const MarkedEdge>;

Edges columnEdges(const LayerEdges& layer, int axis, std::int32_t j) {
  const auto& start = layer.columnStart[axis];
  return Edges(layer.edges[axis]).subspan(start[j], start[j + 1] - start[j]);
}

class UnionFind {
 public:
  explicit UnionFind(std::size_t n) : parent_(n) {
    for (std::size_t i = 0; i < n; ++i) parent_[i] = static_cast<std::uint32_t>(i);
  }
  std::uint32_t find(std::uint32_t x) {
    while (parent_[x] != x) {
      parent_[x] = parent_[parent_[x]];
      x = parent_[x];
    }
    return x;
  }
  /// The smaller root stays: the partition's names do not depend on the order of joins.
  void join(std::uint32_t x, std::uint32_t y) {
    x = find(x);
    y = find(y);
    if (x < y) {
      parent_[y] = x;
    } else {
      parent_[x] = y;
    }
  }

 private:
  std::vector<std::uint32_t> parent_;
};

/// Joins the runs of two neighbouring lines. a, b: their z edges; between: the marked edges that
/// lead from a to b; n: lattice points along z.
void joinLines(Edges a, std::uint32_t runA, Edges b, std::uint32_t runB, Edges between,
               std::int32_t n, UnionFind& sets) {
  std::size_t ia = 0, ib = 0, im = 0;
  std::int32_t low = 0;
  while (low < n) {
    const std::int32_t endA = ia < a.size() ? a[ia].k : n - 1;
    const std::int32_t endB = ib < b.size() ? b[ib].k : n - 1;
    const std::int32_t high = std::min(endA, endB);
    const std::size_t firstMark = im;
    while (im < between.size() && between[im].k <= high) ++im;
    if (static_cast<std::int32_t>(im - firstMark) < high - low + 1) {
      sets.join(runA + static_cast<std::uint32_t>(ia), runB + static_cast<std::uint32_t>(ib));
    }
    if (endA == high) ++ia;
    if (endB == high) ++ib;
    low = high + 1;
  }
}

}  // namespace

SignRuns findOutside(const MarkedEdges& marked, const GridPlan& grid, RunContext& run,
                     std::vector<std::uint32_t>* component) {
  const std::int32_t nx = grid.points[0], ny = grid.points[1], nz = grid.points[2];
  SignRuns signs;
  signs.columns = ny;
  signs.firstRun.resize(static_cast<std::size_t>(nx) * ny + 1);
  std::uint64_t runs = 0;
  for (std::int32_t i = 0; i < nx; ++i) {
    const auto& start = marked.layers[i].columnStart[2];
    for (std::int32_t j = 0; j < ny; ++j) {
      signs.firstRun[signs.line(i, j)] = static_cast<std::uint32_t>(runs);
      runs += start[j + 1] - start[j] + 1;
    }
  }
  if (runs > 0xffffffffu) {
    throw Error(Status::ResourceLimit, "ResourceLimit",
                "the surface has " + std::to_string(runs) +
                    " runs, the limit is 4294967295; use a "
                    "larger cell");
  }
  signs.firstRun.back() = static_cast<std::uint32_t>(runs);

  UnionFind sets(runs);
  const auto joinWithinLayer = [&](std::int32_t i) {
    const LayerEdges& layer = marked.layers[i];
    for (std::int32_t j = 0; j + 1 < ny; ++j) {
      joinLines(columnEdges(layer, 2, j), signs.firstRun[signs.line(i, j)],
                columnEdges(layer, 2, j + 1), signs.firstRun[signs.line(i, j + 1)],
                columnEdges(layer, 1, j), nz, sets);
    }
  };
  const auto joinWithNextLayer = [&](std::int32_t i) {
    const LayerEdges& layer = marked.layers[i];
    for (std::int32_t j = 0; j < ny; ++j) {
      joinLines(columnEdges(layer, 2, j), signs.firstRun[signs.line(i, j)],
                columnEdges(marked.layers[i + 1], 2, j), signs.firstRun[signs.line(i + 1, j)],
                columnEdges(layer, 0, j), nz, sets);
    }
  };
  // Slabs touch only runs of their own; the layers between slabs are joined one after the other.
  constexpr std::int32_t kSlab = 16;
  const std::int32_t slabs = (nx + kSlab - 1) / kSlab;
  parallelFor(static_cast<std::size_t>(slabs), [&](std::size_t s) {
    const std::int32_t begin = static_cast<std::int32_t>(s) * kSlab,
                       end = std::min(begin + kSlab, nx);
    run.checkpoint(Phase::Signs, s, static_cast<std::uint64_t>(slabs));
    for (std::int32_t i = begin; i < end; ++i) {
      joinWithinLayer(i);
      if (i + 1 < end) joinWithNextLayer(i);
    }
  });
  for (std::int32_t i = kSlab - 1; i + 1 < nx; i += kSlab) joinWithNextLayer(i);

  signs.outside.resize(runs);
  for (std::uint64_t r = 0; r < runs; ++r) {
    signs.outside[r] = sets.find(static_cast<std::uint32_t>(r)) == 0;
  }
  if (component != nullptr) {
    component->resize(runs);
    for (std::uint64_t r = 0; r < runs; ++r) {
      (*component)[r] = sets.find(static_cast<std::uint32_t>(r));
    }
  }
  return signs;
}

}  // namespace swept
