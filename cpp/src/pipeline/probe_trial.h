// What the probes of contouring take, from some cells of the run's grid.
// In:    the run's sampler input; a rough surface of it, on a grid of larger cells or the same
//        (rough_surface.h).
// Out:   how many probes contouring casts, and their CPU seconds. Cost: about kProbeSeconds.
// What a cell asks depends on its crossings to the last digit: a recording trembles between the
// placements of a rough sweep, and its creases ask many times more. Each cell is therefore moved
// onto the nearest piece of the whole motion, and the crossings on its edges are looked for there.
// Then it asks as in a run, and every probe gets its true answer, on which the next one may depend.
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
  std::int32_t coarser;  ///< its cells are so many times as large
};

/// For one thread.
ProbeCost tryProbes(const SamplerInput& whole, const RoughSweep& rough, ComponentMethod components);

}  // namespace swept
