// Random mechanisms of small parts from a seed, and the comparison of a report with distances at
// sampled times.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

#include "swept/mechanism.h"

namespace swept::test {

/// Three to six parts among each other: they turn, slide and wait, linearly about a pivot or by
/// screws, at times of their own over a common span; some stand still, two may move as one.
std::vector<MechanismPart> randomMechanism(unsigned seed);

/// The first promise of checkMechanism() that the report breaks, or nothing. Every pair is stamped
/// with FCL, `between` times between two poses; every distance is measured again at the poses named
/// for it.
std::string wrongWith(const std::vector<MechanismPart>& parts, const MechanismReport& report,
                      int between);

}  // namespace swept::test
