// Regions that a curve pushed along a direction or turned about an axis explains, where no simpler
// surface does.
// In, out: Partition of a mesh in which planes, cylinders, cones, spheres and tori were found;
// tolerance in mm. Open ground, and patches that a simpler surface fits worse by far, become
// extrusions and revolutions. True if there are any. Cost: O(open triangles) where there are none.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "solid/recognise/tidy_patches.h"

namespace swept::step {

bool seekProfiles(const HalfEdgeMesh& mesh, const TriangleShapes& shapes, double tolerance,
                  Partition& partition, RunContext& run);

}  // namespace swept::step
