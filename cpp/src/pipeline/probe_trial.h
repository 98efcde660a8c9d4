// What the probes of contouring take, from some cells of a rough surface.
// In:    the whole motion; a rough surface of it on the same grid (rough_surface.h).
// Out:   CPU seconds of all probes. Cost: contouring of the rough surface, and probes in some
// cells:
//        about kProbeSeconds.
// What a cell asks depends on its crossings to the last digit: a recording trembles between the
// placements of a rough sweep, and its creases ask many times more. The crossings of the cells are
// therefore looked for on the whole motion first, by probes along their edges. Every probe starts
// at elements of the whole motion and gets its true answer, on which the next one may depend.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "grid/hermite_grid.h"
#include "grid/marked_edges.h"
#include "sampling/sampler.h"
#include "swept/compute.h"

namespace swept {

/// `part`: the motion that `marked` and `hermite` come from; its placements are some of those of
/// the whole one. `hermite`: its crossings move to where the whole motion has them. For one thread.
double tryProbes(const SamplerInput& whole, const Motion& part, const MarkedEdges& marked,
                 HermiteGrid& hermite, ComponentMethod components, RunContext& run);

}  // namespace swept
