// Builds the Hermite grid: the crossings of marked edges that contribute to the envelope.
//
// In: marked edges, signs. Out: Hermite grid. Units: cells. Cost: O(marked edges).
// Source: docs/pipeline.md, "Crossings"; J. Brummer, bachelor's thesis, Mainz 2017, section 3.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>

#include "grid/hermite_grid.h"
#include "sampling/sampler.h"
#include "signs/signs.h"

namespace swept {

/// Whether the grid also keeps the exact times of its crossings, in double.
enum class ExactTimes : std::uint8_t { Dropped, Kept };

HermiteGrid buildHermiteGrid(const SamplerInput& input, MarkedEdges& marked, const SignRuns& signs,
                             ExactTimes times, RunContext& run);

/// Computes the exact crossing of a marked edge at (i, j, edge.k), seen from its low or high end.
/// `exactSeconds` receives the time in double; it may be null.
using RefineCrossing =
    std::function<Crossing(int axis, std::int32_t i, std::int32_t j, const MarkedEdge& edge,
                           bool fromLow, double* exactSeconds)>;
HermiteGrid buildHermiteGrid(const GridPlan& grid, const MarkedEdges& marked, const SignRuns& signs,
                             ExactTimes times, const RefineCrossing& refine, RunContext& run);

}  // namespace swept
