// Estimates the cost of the probes that contouring casts, by casting the probes of some cells.
// In:    the whole motion; a rough motion (some of its placements), sampled on the same grid
//        (rough_surface.h).
// Out:   number of probes and their CPU seconds.
// Cost:  about kProbeSeconds, or the fraction kProbePart of the estimated time.
// Method: the probes of a cell depend on the exact positions of its crossings. A recorded motion
//        vibrates between the placements of the rough motion. The vibration makes creases, which
//        need many more probes. So the trial first moves the crossings of a cell to the surface of
//        the whole motion. Then it casts the same probes as a run, against elements of the whole
//        motion. The trial must cast the probes, because the hits of earlier probes determine where
//        later ones begin.
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
