// Converts a trajectory into a motion whose chords stay within a given distance of the true paths.
// Cost: O(placements).
// Source: the error bound is the sagitta of a circular arc, r (1 - cos(angle / 2)). Here r bounds
// the distance of all body points from the axis of rotation. For linear interpolation, r is their
// largest distance from the origin of the body; for screw interpolation, that from the screw axis.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "motion/motion.h"
#include "swept/run_context.h"
#include "swept/types.h"

namespace swept {

/// Converts the trajectory. `chord`: largest distance of a true path from its chord (mm, > 0).
/// Throws Error(ResourceLimit) if more than 4 million placements are necessary.
Motion refineMotion(const TriMesh& body, const Trajectory& trajectory, double chord,
                    RunContext& run);

}  // namespace swept
