// What of a sweep is certainly inside, from a few whole copies of the body: most of what a recorded
// motion sweeps lies deep inside and need not be sampled.
//
// In: sampler input with a closed body. Out: the lattice points that the copies enclose. Units:
// cells. Cost: that of sampling the copies, a small part of that of sampling the motion.
// Source: METHOD.md section 2, "what is inside stays inside".
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>

#include "sampling/culling/inside_map.h"
#include "sampling/sampler.h"

namespace swept {

/// Nothing where the motion has too few placements to be worth it, or where enclosed spaces may be
/// hollow.
std::optional<InsideMap> findDeepInside(const SamplerInput& input, RunContext& run);

}  // namespace swept
