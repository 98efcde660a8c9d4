// Random mechanisms of small parts from a seed, and the comparison of a report with distances at
// sampled times.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

#include "swept/mechanism.h"

namespace swept::test {

/// Returns three to six parts near each other. They turn, slide and wait, with linear
/// interpolation about a pivot or with screws, at different times within a common period. Some
/// stand still, and two may move as one body.
std::vector<MechanismPart> randomMechanism(unsigned seed);

/// Returns the first promise of checkMechanism() that the report breaks, or an empty text. Compares
/// every pair with distances of FCL, at `between` times between successive poses, and measures
/// every reported distance again at its poses.
std::string wrongWith(const std::vector<MechanismPart>& parts, const MechanismReport& report,
                      int between);

}  // namespace swept::test
