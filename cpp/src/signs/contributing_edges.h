// Visits the marked edges with an outside end, layer by layer. Cost: O(marked edges).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>

#include "grid/hermite_grid.h"
#include "grid/marked_edges.h"
#include "signs/signs.h"

namespace swept {

/// Tells which points of a lattice line lie outside. outside(k) must be called with ascending k.
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

/// Calls use(first, last) for each run of outside points k of a lattice line. `points`: number of
/// points on the line.
template <class Use>
void forOutsideRuns(const MarkedEdges& marked, const SignRuns& signs, std::int32_t points,
                    std::int32_t i, std::int32_t j, const Use& use) {
  const LayerEdges& layer = marked.layers[i];
  const std::uint8_t* run = signs.outside.data() + signs.firstRun[signs.line(i, j)];
  std::int32_t first = 0;
  for (std::uint32_t n = layer.columnStart[2][j]; n < layer.columnStart[2][j + 1]; ++n, ++run) {
    const std::int32_t last = layer.edges[2][n].k;
    if (*run != 0) use(first, last);
    first = last + 1;
  }
  if (*run != 0) use(first, points - 1);
}

/// Calls use(j, edge, sides) for the marked edges of a layer and axis with an outside end. `sides`
/// has the bits of HermiteEdge::sides. Marked is MarkedEdges or const MarkedEdges.
template <class Marked, class Use>
void forContributing(Marked& marked, const SignRuns& signs, const GridPlan& grid, std::int32_t i,
                     int axis, const Use& use) {
  auto& layer = marked.layers[i];
  for (std::int32_t j = 0; j < grid.points[1]; ++j) {
    const std::uint32_t begin = layer.columnStart[axis][j], end = layer.columnStart[axis][j + 1];
    if (begin == end) continue;
    LineReader low(marked, signs, i, j);
    LineReader high(marked, signs, axis == 0 ? i + 1 : i, axis == 1 ? j + 1 : j);
    for (std::uint32_t e = begin; e < end; ++e) {
      auto& edge = layer.edges[axis][e];
      const bool lowOut = low.outside(edge.k);
      const bool highOut = high.outside(axis == 2 ? edge.k + 1 : edge.k);
      const auto sides = static_cast<std::uint8_t>((lowOut ? HermiteEdge::kLow : 0) |
                                                   (highOut ? HermiteEdge::kHigh : 0));
      if (sides != 0) use(j, edge, sides);
    }
  }
}

}  // namespace swept
