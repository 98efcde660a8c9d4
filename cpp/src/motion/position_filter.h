// Drops poses while the body stays near the last kept pose (position filter).
// In:    a checked trajectory and the bounding box of the body.
// Out:   the trajectory with fewer poses, and the number of dropped poses. Also the largest
//        distance of any point of the box between a dropped pose and the kept pose before it. The
//        filter always keeps the first pose and, if poses are interpolated, the last one.
// Units: mm. Cost: O(poses).
// Promise: at a dropped pose, every point of the body is within `distance` of its position at the
//        kept pose before. So the envelope is too small by at most this depth. If poses are
//        interpolated, the filter also keeps a pose if the turn between its kept neighbours would
//        otherwise reach 90 degrees. So the shortest rotation between kept poses stays unique.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>

#include "swept/types.h"

namespace swept {

struct FilteredTrajectory {
  Trajectory trajectory;
  std::vector<std::int32_t> kept;  ///< per kept pose: its index in the given trajectory
  std::int64_t dropped = 0;
  double distance = 0;  ///< mm, see Out above; at most the given distance
};

FilteredTrajectory filterPositions(const Trajectory& trajectory, const Eigen::AlignedBox3d& body,
                                   double distance);

}  // namespace swept
