// SPDX-License-Identifier: LGPL-2.1-or-later
#include "signs/signs.h"

#include <algorithm>
#include <span>
#include <utility>

#include "base/parallel.h"
#include "base/union_find.h"
#include "swept/types.h"

namespace swept {
namespace {

using Edges = std::span<const MarkedEdge>;

Edges columnEdges(const LayerEdges& layer, int axis, std::int32_t j) {
  const auto& start = layer.columnStart[axis];
  return Edges(layer.edges[axis]).subspan(start[j], start[j + 1] - start[j]);
}

using Runs = std::vector<std::uint32_t>;

/// Joins the runs of two neighbouring lines. `a` and `b`: the marked z edges of the lines.
/// `between`: the marked edges that lead from the first line to the second. n: the number of
/// lattice points along z.
void joinLines(Edges a, std::uint32_t runA, Edges b, std::uint32_t runB, Edges between,
               std::int32_t n, Runs& parent) {
  std::size_t ia = 0, ib = 0, im = 0;
  std::int32_t low = 0;
  while (low < n) {
    const std::int32_t endA = ia < a.size() ? a[ia].k : n - 1;
    const std::int32_t endB = ib < b.size() ? b[ib].k : n - 1;
    const std::int32_t high = std::min(endA, endB);
    const std::size_t firstMark = im;
    while (im < between.size() && between[im].k <= high) ++im;
    if (static_cast<std::int32_t>(im - firstMark) < high - low + 1) {
      unite(parent, runA + static_cast<std::uint32_t>(ia), runB + static_cast<std::uint32_t>(ib));
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
                    " runs of grid points, but the limit is 4294967295; use a larger cell");
  }
  signs.firstRun.back() = static_cast<std::uint32_t>(runs);

  Runs parent = singleSets<std::uint32_t>(runs);
  const auto joinWithinLayer = [&](std::int32_t i) {
    const LayerEdges& layer = marked.layers[i];
    for (std::int32_t j = 0; j + 1 < ny; ++j) {
      joinLines(columnEdges(layer, 2, j), signs.firstRun[signs.line(i, j)],
                columnEdges(layer, 2, j + 1), signs.firstRun[signs.line(i, j + 1)],
                columnEdges(layer, 1, j), nz, parent);
    }
  };
  const auto joinWithNextLayer = [&](std::int32_t i) {
    const LayerEdges& layer = marked.layers[i];
    for (std::int32_t j = 0; j < ny; ++j) {
      joinLines(columnEdges(layer, 2, j), signs.firstRun[signs.line(i, j)],
                columnEdges(marked.layers[i + 1], 2, j), signs.firstRun[signs.line(i + 1, j)],
                columnEdges(layer, 0, j), nz, parent);
    }
  };
  constexpr std::size_t kSlab = 16;  // layers per task
  parallelBlocks(static_cast<std::size_t>(nx), kSlab, [&](std::size_t begin, std::size_t end) {
    run.checkpoint(Phase::Signs, begin, static_cast<std::uint64_t>(nx));
    for (auto i = static_cast<std::int32_t>(begin); i < static_cast<std::int32_t>(end); ++i) {
      joinWithinLayer(i);
      if (i + 1 < nx) joinWithNextLayer(i);
    }
  });

  signs.outside.resize(runs);
  // Links lead to smaller numbers, so one pass in ascending order links each run to its root.
  for (std::uint64_t r = 0; r < runs; ++r) {
    parent[r] = parent[parent[r]];
    signs.outside[r] = parent[r] == 0;
  }
  if (component != nullptr) *component = std::move(parent);
  return signs;
}

}  // namespace swept
