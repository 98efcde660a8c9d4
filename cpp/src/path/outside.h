// Finds placements outside all neighbours, for tasks that only take the part out.
// Units:   mm.
// Cost:    one placement query per candidate.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>

#include "path/ends.h"

namespace swept::path {

/// Returns free placements outside (see outsideTest()), with the orientation of the goal. They are
/// the exits of the End that is returned.
End outside(const Scene& scene, const Demand& demand, const State& goal,
            const Extraction& extraction);

/// Returns a function that tests whether a state is outside. Without a direction, outside means at
/// least the radius of the extraction away from the goal. With a direction, the whole part must lie
/// beyond the box of all neighbours, by at least the largest required distance.
std::function<bool(const State&)> outsideTest(const Scene& scene, const Demand& demand,
                                              const State& goal, const Extraction& extraction);

}  // namespace swept::path
