// SPDX-License-Identifier: LGPL-2.1-or-later
#include "signs/count_crossings.h"

#include <atomic>

#include "base/parallel.h"
#include "signs/contributing_edges.h"
#include "signs/signs.h"

namespace swept {

CrossingCounts countCrossings(const MarkedEdges& marked, const GridPlan& grid, RunContext& run) {
  const SignRuns signs = findOutside(marked, grid, run);
  std::atomic<std::int64_t> crossings{0}, walls{0};
  parallelFor(marked.layers.size(), [&](std::size_t i) {
    std::int64_t edges = 0, both = 0;
    for (int axis = 0; axis < 3; ++axis) {
      forContributing(marked, signs, grid, static_cast<std::int32_t>(i), axis,
                      [&](std::int32_t, const MarkedEdge&, std::uint8_t sides) {
                        ++edges;
                        both += sides == 3;
                      });
    }
    crossings += edges + both;
    walls += both;
  });
  return {crossings, walls};
}

}  // namespace swept
