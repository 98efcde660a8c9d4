// The pivot of a trajectory: the point of the body that moves straight between two poses. With
// S = translation to the pivot, the poses P S and the body S^-1 x are the same motion, and there
// the pivot is the origin; so nothing else of the core needs to know of it. Units: mm. Cost:
// O(vertices), O(poses).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "swept/types.h"

namespace swept {

/// Zero where it changes nothing: copies and screws do not depend on a point of the body. Throws
/// Error(InvalidInput, "BadOption") for what is not finite or beyond the limit of lengths.
Eigen::Vector3d pivotOf(const Trajectory& trajectory);

/// The body in coordinates whose origin is the pivot.
TriMesh seenFromPivot(TriMesh body, const Eigen::Vector3d& pivot);

/// The placements of those coordinates; rotations are unit quaternions.
Trajectory carriedByPivot(Trajectory trajectory, const Eigen::Vector3d& pivot);

/// The placement of the body, from that of the coordinates round the pivot.
Pose backFromPivot(Pose pose, const Eigen::Vector3d& pivot);

}  // namespace swept
