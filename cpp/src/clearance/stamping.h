// Computes the smallest distance as a reference, slowly: with one distance query of the library FCL
// at each pose.
// In:      body, poses, neighbour.
// Out:     the smallest distance and the pose at which it occurs.
// Units:   mm.
// Cost:    one query per pose.
// This is an independent check for tests and for `swept clearance --stamp`. It shares no search
// code with the fast computation. It does not examine the motion between the given poses.
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

/// Does the same for a neighbour that also moves. `neighbourPoses[i]` is the pose of the neighbour
/// at the time of `poses[i]`.
StampedMinimum stampEveryPose(const TriMesh& body, const std::vector<Pose>& poses,
                              const TriMesh& neighbour, const std::vector<Pose>& neighbourPoses,
                              RunContext& run);

/// Returns the poses of the trajectory and `between` evenly spaced poses inside each step. If
/// `between` is 0, returns only the poses of the trajectory.
std::vector<Pose> densePoses(const Trajectory& trajectory, int between);

}  // namespace swept::clearance
