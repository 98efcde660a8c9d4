// Input check of the trajectory.
// In:    any poses. Out: finite, normalised, strictly ordered in time, equal neighbours collapsed.
// Units: mm, s, rad. Cost: O(poses).
// Rows 17 to 23 of the table of bad input (docs/bad_input.md).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "swept/report.h"
#include "swept/types.h"

namespace swept {

/// What becomes of a pose that repeats the placement before it at a later time: for the shape of a
/// sweep it says nothing; where others move meanwhile it says that the body waits.
enum class RepeatedPoses { Drop, Keep };

struct CheckedTrajectory {
  Trajectory trajectory;
  std::vector<std::int32_t> given;  ///< per pose: its number among those given
  std::vector<Finding> findings;
};

/// Throws Error(InvalidInput) with code EmptyTrajectory, BadPose, NotRigid, AmbiguousTurn (only
/// where poses are interpolated: a turn within 1 degree of 180 between two poses has no shortest
/// way).
CheckedTrajectory checkTrajectory(const Trajectory& trajectory,
                                  RepeatedPoses repeated = RepeatedPoses::Drop);

/// Throws Error(InvalidInput, "BadOption", name, value and allowed range in the text). Row 16.
void checkOptions(const Options& options);

}  // namespace swept
