// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sampling/hermite.h"

#include <algorithm>
#include <atomic>
#include <span>

#include "base/parallel.h"
#include "sampling/crossing_refine.h"

namespace swept {
namespace {

/// Two crossings of one edge are kept at least this far apart (cells), so that a sheet without
/// thickness still has two sides.
constexpr float kLeastWall = 2e-3f;

/// Steps along a line with rising k and tells whether the outside holds lattice point k.
class LineReader {
 public:
  LineReader(const MarkedEdges& marked, const SignRuns& signs, std::int32_t i, std::int32_t j)
      : run_(signs.outside.data() + signs.firstRun[signs.line(i, j)]) {
    const LayerEdges& layer = marked.layers[i];
    edge_ = layer.edges[2].data() + layer.columnStart[2][j];
    end_ = layer.edges[2].data() + layer.columnStart[2][j + 1];
  }
  bool outside(std::int32_t k) {
    while (edge_ != end_ && edge_->k < k) {
      ++edge_;
      ++run_;
    }
    return *run_ != 0;
  }

 private:
  const std::uint8_t* run_;
  const MarkedEdge* edge_;
  const MarkedEdge* end_;
};

/// Calls use(axis, j, edge, sides) for the marked edges of a layer of which an end is outside.
template <class Use>
void forContributing(const MarkedEdges& marked, const SignRuns& signs, const GridPlan& grid,
                     std::int32_t i, int axis, const Use& use) {
  const LayerEdges& layer = marked.layers[i];
  for (std::int32_t j = 0; j < grid.points[1]; ++j) {
    const std::uint32_t begin = layer.columnStart[axis][j], end = layer.columnStart[axis][j + 1];
    if (begin == end) continue;
    LineReader low(marked, signs, i, j);
    LineReader high(marked, signs, axis == 0 ? i + 1 : i, axis == 1 ? j + 1 : j);
    for (std::uint32_t e = begin; e < end; ++e) {
      const MarkedEdge& edge = layer.edges[axis][e];
      const bool lowOut = low.outside(edge.k);
      const bool highOut = high.outside(axis == 2 ? edge.k + 1 : edge.k);
      const auto sides = static_cast<std::uint8_t>((lowOut ? HermiteEdge::kLow : 0) |
                                                   (highOut ? HermiteEdge::kHigh : 0));
      if (sides != 0) use(j, edge, sides);
    }
  }
}

void separate(Crossing& low, Crossing& high) {
  const float gap = high.fraction - low.fraction;
  if (gap >= kLeastWall) return;
  const float middle =
      std::clamp((low.fraction + high.fraction) / 2, kLeastWall / 2, 1 - kLeastWall / 2);
  low.fraction = middle - kLeastWall / 2;
  high.fraction = middle + kLeastWall / 2;
}

}  // namespace

HermiteGrid buildHermiteGrid(const SamplerInput& input, MarkedEdges& marked, const SignRuns& signs,
                             RunContext& run) {
  const GridPlan& grid = input.grid;
  const auto layers = static_cast<std::size_t>(grid.points[0]);
  HermiteGrid out;
  out.plan = grid;
  out.layers.resize(layers);
  std::vector<std::uint64_t> counts(layers, 0);
  std::atomic<std::int64_t> markedCount{0};
  parallelFor(layers, [&](std::size_t layer) {
    const auto i = static_cast<std::int32_t>(layer);
    HermiteLayer& target = out.layers[layer];
    std::uint32_t crossings = 0;
    for (int axis = 0; axis < 3; ++axis) {
      markedCount += static_cast<std::int64_t>(marked.layers[layer].edges[axis].size());
      auto& start = target.columnStart[axis];
      start.assign(grid.points[1] + 1, 0);
      forContributing(marked, signs, grid, i, axis,
                      [&](std::int32_t j, const MarkedEdge& edge, std::uint8_t sides) {
                        target.edges[axis].push_back({crossings, edge.k, sides});
                        ++start[j];
                        crossings += sides == 3 ? 2 : 1;
                      });
      exclusiveScan(start);
    }
    counts[layer] = crossings;
  });
  out.markedEdges = markedCount;
  const std::uint64_t total = exclusiveScan(counts);
  if (total > 0xfffffff0u) {
    throw Error(Status::ResourceLimit, "ResourceLimit",
                "the envelope has " + std::to_string(total) +
                    " crossings, the limit is 4294967280; use a larger cell");
  }
  out.crossings.resize(total);
  const CrossingRefiner refiner(input, marked);
  std::atomic<std::int64_t> sheets{0};
  parallelFor(layers, [&](std::size_t layer) {
    run.checkpoint(Phase::Signs, layer, layers);
    const auto i = static_cast<std::int32_t>(layer);
    HermiteLayer& target = out.layers[layer];
    target.firstCrossing = static_cast<std::uint32_t>(counts[layer]);
    std::int64_t sheetEdges = 0;
    for (int axis = 0; axis < 3; ++axis) {
      auto next = target.edges[axis].begin();
      forContributing(marked, signs, grid, i, axis,
                      [&](std::int32_t j, const MarkedEdge& edge, std::uint8_t sides) {
                        next->first += target.firstCrossing;
                        Crossing* crossing = &out.crossings[next->first];
                        ++next;
                        if (sides & HermiteEdge::kLow) {
                          *crossing = refiner.refine(axis, i, j, edge.k, edge.lowFraction,
                                                     edge.lowElement, true);
                          ++crossing;
                        }
                        if (sides & HermiteEdge::kHigh) {
                          *crossing = refiner.refine(axis, i, j, edge.k, edge.highFraction,
                                                     edge.highElement, false);
                        }
                        if (sides == 3) {
                          sheetEdges += edge.lowFraction == edge.highFraction;
                          separate(crossing[-1], crossing[0]);
                        }
                      });
    }
    sheets += sheetEdges;
  });
  out.sheetEdges = sheets;
  return out;
}

}  // namespace swept
