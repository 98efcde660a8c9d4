// Checks a given motion like a path that was found, without changing it.
// In:      part, motion, and neighbours with their rules.
// Out:     a report like that of findPath(). The verdict is Found if the whole motion keeps all
//        clearances outside the release zones. Otherwise the report gives the blocking neighbour,
//        the time, and how far the part is from its goal at that time.
// Units:   mm, s.
// Cost:    one exact check per neighbour.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "swept/path.h"

namespace swept::path {

/// The motion must have at least two keys and ascending times. Failures are in report.status, as
/// for findPath(). BadOption can also mean that the motion is too short for its release zones.
PathReport checkGivenMotion(const TriMesh& part, const Trajectory& motion,
                            const std::vector<ClearanceNeighbour>& neighbours,
                            const PathOptions& options, RunContext& run);

}  // namespace swept::path
