// Reference: distance at every pose, one query each, by FCL's own hierarchy. Slow and simple.
// In: body, poses, neighbour, mm. Out: the smallest distance and its pose. Cost: one query a pose.
// Kept as an independent witness for tests and for `swept clearance --stamp`; shares no search code
// with the fast way. Sees nothing between the poses it is given.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "swept/run_context.h"
#include "swept/types.h"

namespace swept::clearance {

struct StampedMinimum {
  double distance = 0;
  std::int64_t pose = -1;
};

StampedMinimum stampEveryPose(const TriMesh& body, const std::vector<Pose>& poses,
                              const TriMesh& neighbour, RunContext& run);

/// The same if the neighbour moves too. `neighbourPoses` has one pose for each of `poses`, at the
/// same time.
StampedMinimum stampEveryPose(const TriMesh& body, const std::vector<Pose>& poses,
                              const TriMesh& neighbour, const std::vector<Pose>& neighbourPoses,
                              RunContext& run);

/// The trajectory's poses with `between` more, evenly spaced, inside every step (none: unchanged).
std::vector<Pose> densePoses(const Trajectory& trajectory, int between);

}  // namespace swept::clearance
