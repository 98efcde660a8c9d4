// Checks the parts of a mechanism, and prepares them for checkMechanism(), which searches for the
// smallest distances of all pairs. Finds the time span that all motions have in common.
// In:      parts as the caller gives them.
// Out:     bounding volume hierarchies and timed motions, with the pivot of each part as the origin
//          of its coordinates; and the common time span.
// Units:   mm, s.
// Cost:    O(n log n) for n triangles; parts are prepared in parallel.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "clearance/part.h"
#include "clearance/relative_motion.h"
#include "swept/mechanism.h"

namespace swept::clearance {

struct PreparedPart {
  Part part;
  bool mended;  ///< true: `part` is a repaired copy, whose triangle indices mean nothing to the
                ///< caller
  Eigen::Vector3d pivot;
  TimedMotion motion;
  std::vector<Finding> findings;
};

/// Throws Error(InvalidInput) with the codes of checkMechanism(). Each message names the part.
std::vector<PreparedPart> prepareParts(const std::vector<MechanismPart>& parts, RunContext& run);

/// Returns the checked motion of one part, as poses of its pivot.
Trajectory timedPoses(const MechanismPart& part, std::vector<Finding>& findings);

/// Returns the time span that all motions share. Throws Error(InvalidInput) with the code
/// NothingMoves or NoCommonTime. Adds a finding about motions that extend beyond the span.
TimeInterval commonTime(const std::vector<MechanismPart>& parts,
                        const std::vector<PreparedPart>& prepared, std::vector<Finding>& findings);

}  // namespace swept::clearance
