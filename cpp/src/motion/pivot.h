// The pivot of a trajectory: the body point that moves along a straight line between two poses. Let
// S be the translation by the pivot. The poses P S with the body points S^-1 x give the same motion
// as the poses P with the body points x. The origin of the moved body is then the pivot, so no
// other part of the core needs to know the pivot. Units: mm. Cost: O(vertices), O(poses).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "swept/types.h"

namespace swept {

/// Returns the pivot if the interpolation is linear, otherwise zero: copies and screw motions do
/// not depend on the pivot. Throws Error(InvalidInput, "BadOption") if the pivot is not finite or
/// too far away.
Eigen::Vector3d pivotOf(const Trajectory& trajectory);

/// Returns the body in coordinates whose origin is the pivot.
TriMesh seenFromPivot(TriMesh body, const Eigen::Vector3d& pivot);

/// Returns poses that move the result of seenFromPivot() as `trajectory` moves the given body.
/// Rotations must be unit quaternions.
Trajectory carriedByPivot(Trajectory trajectory, const Eigen::Vector3d& pivot);

/// Converts a pose of carriedByPivot() back to a pose of the given body.
Pose backFromPivot(Pose pose, const Eigen::Vector3d& pivot);

}  // namespace swept
