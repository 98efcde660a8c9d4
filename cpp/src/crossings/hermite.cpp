// SPDX-License-Identifier: LGPL-2.1-or-later
#include "crossings/hermite.h"

#include <algorithm>
#include <atomic>

#include "base/parallel.h"
#include "crossings/crossing_refine.h"
#include "signs/contributing_edges.h"

namespace swept {
namespace {

/// Smallest distance (cells) between the two crossings of an edge, so that a sheet without
/// thickness still has two sides. This is twice kMinPointDistance (crossing_refine.cpp), the
/// distance of crossings from the ends of an edge.
constexpr float kMinWall = 2e-3f;

void separate(Crossing& low, Crossing& high) {
  const float gap = high.fraction - low.fraction;
  if (gap >= kMinWall) return;
  const float middle = std::clamp((low.fraction + high.fraction) / 2, kMinWall, 1 - kMinWall);
  low.fraction = middle - kMinWall / 2;
  high.fraction = middle + kMinWall / 2;
}

}  // namespace

HermiteGrid buildHermiteGrid(const SamplerInput& input, MarkedEdges& marked, const SignRuns& signs,
                             ExactTimes times, RunContext& run) {
  const CrossingRefiner refiner(input, marked);
  return buildHermiteGrid(
      input.grid, marked, signs, times,
      [&](int axis, std::int32_t i, std::int32_t j, const MarkedEdge& edge, bool fromLow,
          double* exactSeconds) {
        return refiner.refine(axis, i, j, edge.k, fromLow ? edge.lowFraction : edge.highFraction,
                              fromLow ? edge.lowElement : edge.highElement, fromLow, exactSeconds);
      },
      run);
}

HermiteGrid buildHermiteGrid(const GridPlan& grid, const MarkedEdges& marked, const SignRuns& signs,
                             ExactTimes times, const RefineCrossing& refine, RunContext& run) {
  const auto layers = static_cast<std::size_t>(grid.points[0]);
  HermiteGrid out;
  out.plan = grid;
  out.layers.resize(layers);
  std::vector<std::uint64_t> counts(layers, 0);
  parallelFor(layers, [&](std::size_t layer) {
    const auto i = static_cast<std::int32_t>(layer);
    HermiteLayer& target = out.layers[layer];
    std::uint32_t crossings = 0;
    for (int axis = 0; axis < 3; ++axis) {
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
  const std::uint64_t total = exclusiveScan(counts);
  if (total > 0xfffffff0u) {
    throw Error(Status::ResourceLimit, "ResourceLimit",
                "the envelope has " + std::to_string(total) +
                    " grid crossings, but the limit is 4294967280; use a larger cell");
  }
  out.crossings.resize(total);
  out.winner.resize(total);
  if (times == ExactTimes::Kept) out.exactSeconds.resize(total);
  const auto exactSecondsOf = [&](const Crossing* crossing) {
    return out.exactSeconds.empty() ? nullptr : &out.exactSeconds[crossing - out.crossings.data()];
  };
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
                        std::uint32_t* winner = &out.winner[next->first];
                        ++next;
                        if (sides & HermiteEdge::kLow) {
                          *crossing = refine(axis, i, j, edge, true, exactSecondsOf(crossing));
                          *winner++ = edge.lowElement;
                          ++crossing;
                        }
                        if (sides & HermiteEdge::kHigh) {
                          *crossing = refine(axis, i, j, edge, false, exactSecondsOf(crossing));
                          *winner = edge.highElement;
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
