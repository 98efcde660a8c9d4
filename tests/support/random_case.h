// Random bodies and motions from a seed, for property tests.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <random>

#include "swept/types.h"

namespace swept::test {

/// Returns a box, ball, cylinder, torus, square ring or two overlapping ones of these, turned by
/// random angles.
TriMesh randomBody(std::mt19937& random);
/// Returns a motion of two to four poses. A step turns by up to 100 degrees and travels up to the
/// size of the bodies. The interpolation is none, linear or screw.
Trajectory randomMotion(std::mt19937& random);
/// Returns a random rotation and translation.
Eigen::Isometry3d randomFrame(std::mt19937& random);
/// Returns the same mesh with vertices and triangles in another order.
TriMesh shuffled(const TriMesh& mesh, std::mt19937& random);

}  // namespace swept::test
