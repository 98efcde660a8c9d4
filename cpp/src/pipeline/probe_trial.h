// What the probes of contouring take, from some of its cells.
// In:    the whole motion; a rough surface of it on the same grid (rough_surface.h).
// Out:   how many probes contouring casts, and their CPU seconds.
// Cost:  about kProbeSeconds, or kProbePart of what it finds.
// What a cell asks depends on its crossings to the last digit: a
// recording trembles between the placements of a rough sweep, and its creases ask many times more.
// The crossings on the edges of each cell are therefore looked for on the whole motion first. Then
// the cell asks as in a run, and every probe starts at elements of the whole motion and gets its
// true answer, on which the next one may depend.
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
  const Motion& motion;  ///< some placements of the whole motion
  const MarkedEdges& marked;
  const HermiteGrid& hermite;
};

/// For one thread.
ProbeCost tryProbes(const SamplerInput& whole, const RoughSweep& rough, ComponentMethod components);

}  // namespace swept
