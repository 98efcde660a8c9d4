// The parts of a mechanism as the search takes them: checked, prepared, joined over their common
// time. In:    parts as given. Units: mm, s. Out:   hierarchies and timed motions in coordinates
// whose origin is the pivot of each part. Cost:  O(n log n) in the triangles, parts side by side.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "clearance/part.h"
#include "clearance/relative_motion.h"
#include "swept/mechanism.h"

namespace swept::clearance {

struct PreparedPart {
  Part part;
  bool mended;  ///< the numbers of its triangles mean nothing to the caller
  Eigen::Vector3d pivot;
  TimedMotion motion;
  std::vector<Finding> findings;
};

/// Throws Error(InvalidInput) as checkMechanism() says; every message names the part.
std::vector<PreparedPart> prepareParts(const std::vector<MechanismPart>& parts, RunContext& run);

/// The motion of one part, checked, with its pivot's poses.
Trajectory timedPoses(const MechanismPart& part, std::vector<Finding>& findings);

/// Common to all motions. Throws NothingMoves, NoCommonTime; says of motions that go on beyond it.
TimeInterval commonTime(const std::vector<MechanismPart>& parts,
                        const std::vector<PreparedPart>& prepared, std::vector<Finding>& findings);

}  // namespace swept::clearance
