// Checks and corrects the trajectory before a run.
// In:    any poses. Out: finite poses with unit quaternions and times that never decrease.
//        Successive poses with equal placements become one, unless RepeatedPoses::Keep is given and
//        the second pose has a later time.
// Units: mm, s, rad. Cost: O(poses).
// Covers rows 17 to 23 of docs/bad_input.md.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "swept/report.h"
#include "swept/types.h"

namespace swept {

/// What to do with a pose that repeats the previous placement at a later time. Drop: for a sweep,
/// whose shape such a pose does not change. Keep: for a body that waits while other parts move.
enum class RepeatedPoses { Drop, Keep };

struct CheckedTrajectory {
  Trajectory trajectory;
  std::vector<std::int32_t> given;  ///< per pose: its index in the given trajectory
  std::vector<Finding> findings;
};

/// Checks and corrects the poses. Throws Error(InvalidInput) with the code EmptyTrajectory,
/// BadPose, NotRigid or AmbiguousTurn. AmbiguousTurn occurs only if poses are interpolated: within
/// 1 degree of 180, the rotation between two poses has no unique shortest direction.
CheckedTrajectory checkTrajectory(const Trajectory& trajectory,
                                  RepeatedPoses repeats = RepeatedPoses::Drop);

}  // namespace swept
