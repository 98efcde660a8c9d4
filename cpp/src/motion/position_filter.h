// Position filter: leaves out poses while the body stays near the last one that was kept.
// In:    a checked trajectory, the body's box. Out: the trajectory with fewer poses, how many were
//        dropped, and the largest distance of any point of the box between a dropped pose and the
//        kept one before it. The first pose is always kept, of interpolated motions the last as
//        well.
// Units: mm. Cost: O(poses).
// Invariant: a dropped pose's copy of the body stays within `distance` of a kept copy, so what the
// envelope loses is no deeper than that. Poses of interpolated motions are never dropped where the
// turn between their kept neighbours would reach 90 degrees: the path between these stays unique.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>

#include "swept/types.h"

namespace swept {

struct FilteredTrajectory {
  Trajectory trajectory;
  std::vector<std::int32_t> kept;  ///< per pose: its number in the trajectory before
  std::int64_t dropped = 0;
  double distance = 0;  ///< mm, at most the given one
};

FilteredTrajectory filterPositions(const Trajectory& trajectory, const Eigen::AlignedBox3d& body,
                                   double distance);

}  // namespace swept
