// Finds regions on an extrusion or a revolution, where no simpler surface fits.
// In, out: Partition of a mesh in which planes, cylinders, cones, spheres and tori were recognised;
// tolerance in mm. Open ground, and patches whose simpler surface fits much worse, become
// extrusions and revolutions. Returns true if there are any. Cost: O(open triangles) if there are
// none.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "solid/mesh/patches.h"

namespace swept::step {

bool seekProfiles(const HalfEdgeMesh& mesh, const TriangleShapes& shapes, double tolerance,
                  Partition& partition, RunContext& run);

}  // namespace swept::step
