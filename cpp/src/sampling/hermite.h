// Marked edges + outside -> Hermite grid of the crossings that contribute to the envelope.
// In: consumed layer by layer, so that memory falls as it is read. Cost: O(marked edges).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "data/hermite_grid.h"
#include "sampling/sampler.h"
#include "sampling/signs.h"

namespace swept {

HermiteGrid buildHermiteGrid(const SamplerInput& input, MarkedEdges& marked, const SignRuns& signs,
                             RunContext& run);

}  // namespace swept
