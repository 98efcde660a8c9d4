// Finds points that certainly lie inside a sweep, by sampling a few whole copies of the body. Most
// of the sweep of a recorded motion lies deep inside (inside_map.h) and then need not be sampled.
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

/// Returns nothing if the motion has too few placements, if the map would hide too little, or if
/// nothing may be hidden: without culling, with a cache, for a body that is not orientable, or if
/// enclosed spaces do not always count as inside.
std::optional<InsideMap> findDeepInside(const SamplerInput& input, RunContext& run);

}  // namespace swept
