// Marked edges and the outside -> Hermite grid: the crossings that contribute to the envelope.
// In: marked edges (consumed layer by layer, so that memory falls meanwhile), signs. Out: Hermite
// grid. Units: cells. Cost: O(marked edges).
// Source: METHOD.md section 2, "Sampling"; thesis section 3.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>

#include "grid/hermite_grid.h"
#include "sampling/sampler.h"
#include "signs/signs.h"

namespace swept {

HermiteGrid buildHermiteGrid(const SamplerInput& input, MarkedEdges& marked, const SignRuns& signs,
                             RunContext& run);

/// Computes the exact crossing of a marked edge at (i, j, edge.k), seen from its low or high end.
using RefineCrossing = std::function<Crossing(int axis, std::int32_t i, std::int32_t j,
                                              const MarkedEdge& edge, bool fromLow)>;
HermiteGrid buildHermiteGrid(const GridPlan& grid, const MarkedEdges& marked, const SignRuns& signs,
                             const RefineCrossing& refine, RunContext& run);

}  // namespace swept
