// Path of a part without neighbours to check: there are none, or rules ignore all of them.
// In:      the part with its task or motion.
// Out:     a report like that of a found path, with infinite clearance.
// Units:   mm.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "swept/sequence.h"

namespace swept::path {

/// Returns the motion of the part if it has one. Otherwise a straight path from the start, from
/// `far` along the direction, or from the given radius above the goal.
PathReport freeWay(const SequencePart& part, const PathOptions& options, double far);

}  // namespace swept::path
