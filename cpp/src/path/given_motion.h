// A motion that exists already, certified as a path is; nothing of it is changed.
// In:    part, motion, neighbours with what they ask for. Out: a report as findPath() gives it:
//        found where the whole motion keeps every clearance outside the release zones; else what
//        is in the way, when, and how far the part is from its goal there.
// Units: mm, s. Cost: an exact check a neighbour.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "swept/path.h"

namespace swept::path {

/// The motion has at least two keys and times that grow. Failures are in report.status, as for
/// findPath(); BadOption also where the motion is too short for its release zones.
PathReport checkGivenMotion(const TriMesh& part, const Trajectory& motion,
                            const std::vector<ClearanceNeighbour>& neighbours,
                            const PathOptions& options, RunContext& run);

}  // namespace swept::path
