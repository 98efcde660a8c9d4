// Returns a path of a part that no neighbour blocks: there are no neighbours, or rules ignore all
// of them.
// In:      the part with its task or motion.
// Out:     a report like that of a found path, with infinite clearance.
// Units:   mm.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "swept/sequence.h"

namespace swept::path {

/// If the part has a motion, this motion is the path. Otherwise the path leads in straight lines
/// through the via poses to the goal. It begins at the start, or `far` (mm) from the goal in the
/// given direction, or at the given radius above the goal.
PathReport unblockedPath(const SequencePart& part, const PathOptions& options, double far);

}  // namespace swept::path
