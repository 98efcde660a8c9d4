// "Just get it out": placements that are out, and whether one is.
// Units: mm. Cost: a question about a placement for each candidate.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>

#include "path/ends.h"

namespace swept::path {

/// Placements that are free and out, standing as at the goal, each a way out of its own.
End outside(const Scene& scene, const Demand& demand, const State& goal,
            const Extraction& extraction);

/// At least the radius away from the goal; or, along the direction, past all neighbours with the
/// clearance asked for.
std::function<bool(const State&)> outTest(const Scene& scene, const Demand& demand,
                                          const State& goal, const Extraction& extraction);

}  // namespace swept::path
