// Finds the elementary surfaces a mesh was made of.
// In: HalfEdgeMesh, tolerance in mm. Out: patches in a Partition: planes, cylinders, cones,
// spheres, tori, extrusions, revolutions, each edge-connected with every mesh vertex within the
// tolerance; what fits nothing stays unassigned. Patches that go round their surface are cut
// (cut_patches.h). Cost: O(triangles x surfaces tried).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "solid/mesh/patches.h"

namespace swept::step {

/// whole: the mesh before it was thinned, or the same.
void recogniseSurfaces(const HalfEdgeMesh& mesh, const HalfEdgeMesh& whole, double tolerance,
                       Partition& partition, RunContext& run);

}  // namespace swept::step
