// A second look at a run that may take too much memory: the same sweep on a coarse grid.
//
// The estimate of plan.h knows the box of the sweep only: two or three times too much for most
// sweeps, too little where thin walls abound. Here the crossings are counted on two coarse grids,
// which tells how their number grows. Cost: a run's sampling at kPilotCells and at half of it.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "geometry/body_topology.h"
#include "pipeline/plan.h"

namespace swept {

constexpr double kPilotCells = 256;  ///< along the longest side

/// The estimate, with what the pilot says of memory and triangles. Unchanged if
/// the grid is not much finer than the pilot's, or what is asked for is no plain sweep.
Estimate estimateByPilot(const Estimate& estimate, const Prepared& prepared,
                         const BodyTopology& topology, const Options& options, RunContext& run);

}  // namespace swept
