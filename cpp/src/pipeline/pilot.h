// Improves the estimate of runs that may need too much memory, by sampling the sweep on coarse
// grids.
//
// The estimate of plan.h only knows the bounding box of the sweep. It is two or three times too
// high for most sweeps, and too low if there are many thin walls. The pilot counts the crossings on
// two coarse grids and extrapolates their growth. Cost: sampling on a grid with kPilotCells cells
// along its longest side, and on one with half as many.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "geometry/body_topology.h"
#include "pipeline/plan.h"

namespace swept {

constexpr double kPilotCells = 256;  ///< along the longest side

/// Returns `estimate` with better values for memory and triangles. Returns the given estimate in
/// these cases: the envelope has an offset or is conservative; the grid is not much finer than that
/// of the pilot; the motion is not interpolated and has too many poses to be sampled for an
/// estimate; the samples have no crossings or do not fit into memory.
Estimate estimateByPilot(const Estimate& estimate, const Prepared& prepared,
                         const BodyTopology& topology, const Options& options, RunContext& run);

}  // namespace swept
