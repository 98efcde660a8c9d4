// Finds points that certainly lie inside a sweep, from a few whole copies of the body. Most of the
// sweep of a recorded motion lies deep inside and need not be sampled.
//
// In: sampler input with a closed body. Out: the lattice points that the copies enclose.
// Units: cells. Cost: sampling the copies, a small part of sampling the motion.
// Source: docs/pipeline.md, "Culling".
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>

#include "sampling/culling/inside_map.h"
#include "sampling/sampler.h"

namespace swept {

/// Returns nothing if the motion has too few placements to be worth it, or if enclosed spaces may
/// be hollow.
std::optional<InsideMap> findDeepInside(const SamplerInput& input, RunContext& run);

}  // namespace swept
