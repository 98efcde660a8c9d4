// Steps of the recognition that change the Partition of a mesh. recogniseSurfaces() calls them in
// this order, after it has searched for surfaces from all seeds (seek_surface.h).
// Units:   mm, rad.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "solid/mesh/patches.h"

namespace swept::step {

/// Prepares grown patches to become faces. Leftover triangles beside a patch join it, pieces of one
/// surface become one patch, and islands inside a patch are filled. Patches that cost more facets
/// than they save are dropped. All vertices of a patch stay within the tolerance of its surface,
/// except for a few small triangles between patches. Cost: O(triangles x rounds).
void tidyPatches(const HalfEdgeMesh& mesh, const TriangleShapes& shapes, double tolerance,
                 Partition& partition);

/// Finds extrusions and revolutions in unassigned triangles, and in patches that such a surface
/// fits much better than their own. Returns true if it found any. Cost: O(unassigned triangles) if
/// the mesh has no such surfaces.
bool seekProfiles(const HalfEdgeMesh& mesh, const TriangleShapes& shapes, double tolerance,
                  Partition& partition, RunContext& run);

/// Ensures that no face needs a seam. Rotates the reference direction of each surface, so that its
/// seam lies outside the face. If the face leaves no gap for the seam, cuts the patch into halves
/// and stores the cutting planes in Partition::cuts. Cost: O(triangles).
void cutRoundPatches(const HalfEdgeMesh& mesh, Partition& partition);

}  // namespace swept::step
