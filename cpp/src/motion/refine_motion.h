// Trajectory -> motion whose chords stay within a given distance of the true paths.
// Cost: O(placements). Source of the bound: sagitta of a circular arc, r (1 - cos(angle / 2)), at
// the largest radius of the body about the centre of rotation (the body's origin for linear
// interpolation, the screw axis for screw interpolation).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "motion/motion.h"
#include "swept/run_context.h"
#include "swept/types.h"

namespace swept {

/// chord: mm, > 0. Throws Error(ResourceLimit) when more than 4 million placements would be needed.
Motion refineMotion(const TriMesh& body, const Trajectory& trajectory, double chord,
                    RunContext& run);

}  // namespace swept
