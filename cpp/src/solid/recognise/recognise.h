// Recognises the surfaces from which a mesh was made.
// In:      HalfEdgeMesh, tolerance.
// Out:     patches in a Partition: planes, cylinders, cones, spheres, tori, extrusions and
//          revolutions. Each is edge-connected, with all vertices within the tolerance. Triangles
//          that fit nothing stay unassigned. Patches that close on themselves are cut (steps.h).
// Units:   mm.
// Cost:    O(triangles x surfaces tried).
// Source:  region growing with refitting (Besl and Jain 1988); survey in Varady, Martin and Cox
//          1997.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "solid/mesh/patches.h"

namespace swept::step {

/// `whole`: the mesh before it was thinned, or the same mesh.
void recogniseSurfaces(const HalfEdgeMesh& mesh, const HalfEdgeMesh& whole, double tolerance,
                       Partition& partition, RunContext& run);

}  // namespace swept::step
