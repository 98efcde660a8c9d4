// A second look at a run that seems to take too much memory: the same sweep on a coarse grid.
//
// The estimate of plan.h knows the box of the sweep only and errs to the safe side by two or three
// times. Here the crossings are counted on a coarse grid; their number grows as the square of the
// resolution. Cost: a run's sampling at kPilotCells.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "pipeline/plan.h"
#include "sampling/body_topology.h"

namespace swept {

constexpr double kPilotCells = 256;  ///< along the longest side

/// The estimate, with what the pilot says of memory and triangles where it says less. Unchanged if
/// the grid is not much finer than the pilot's, or what is asked for is no plain sweep.
Estimate estimateByPilot(const Estimate& estimate, const Prepared& prepared,
                         const BodyTopology& topology, const Options& options, RunContext& run);

}  // namespace swept
