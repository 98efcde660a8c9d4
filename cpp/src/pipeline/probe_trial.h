// Estimates the cost of the probes that contouring casts, from a sample of the cells.
// In:    the whole motion; a rough surface of it on the same grid (rough_surface.h).
// Out:   number of probes and their CPU seconds.
// Cost:  about kProbeSeconds, or the fraction kProbePart of the estimated time.
// Method: the probes of a cell depend on the exact positions of its crossings. A recorded motion
//        trembles between the placements of a rough sweep. Trembling makes creases, which need many
//        more probes. So the trial first moves the crossings of a cell to the surface of the whole
//        motion. Then it casts the same probes as a run, against elements of the whole motion,
//        because the positions of later probes depend on the answers to earlier ones.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "grid/hermite_grid.h"
#include "grid/marked_edges.h"
#include "sampling/sampler.h"
#include "swept/compute.h"

namespace swept {

struct ProbeCost {
  double casts = 0, seconds = 0;
};

struct RoughSweep {
  const Motion& motion;  ///< has some placements of the whole motion
  const MarkedEdges& marked;
  const HermiteGrid& hermite;
};

/// Returns the estimated cost for all cells. Runs on the calling thread only.
ProbeCost tryProbes(const SamplerInput& whole, const RoughSweep& rough, ComponentMethod components);

}  // namespace swept
