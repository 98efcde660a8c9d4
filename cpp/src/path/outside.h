// Placements that are outside all neighbours, for tasks that only have to get the part out.
// Units:   mm.
// Cost:    one placement query per candidate.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>

#include "path/ends.h"

namespace swept::path {

/// Returns free placements outside, with the orientation of the goal. Each of them is an exit of
/// the End.
End outside(const Scene& scene, const Demand& demand, const State& goal,
            const Extraction& extraction);

/// Returns a test whether a state is outside: at least the radius away from the goal; or, with a
/// direction, past all neighbours by the required clearance.
std::function<bool(const State&)> outTest(const Scene& scene, const Demand& demand,
                                          const State& goal, const Extraction& extraction);

}  // namespace swept::path
