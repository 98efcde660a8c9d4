// Counts the crossings of marked edges that contribute to the envelope.
//
// In: marked edges. Out: counts. Cost: that of findOutside() (signs.h).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>

#include "grid/grid_plan.h"
#include "grid/marked_edges.h"
#include "swept/run_context.h"

namespace swept {

struct CrossingCounts {
  std::int64_t crossings = 0;  ///< one for each outside end of an edge
  std::int64_t walls = 0;      ///< edges with both ends outside, on two sides of a thin wall
};

CrossingCounts countCrossings(const MarkedEdges& marked, const GridPlan& grid, RunContext& run);

}  // namespace swept
