// The steps of recognition, in the order in which recogniseSurfaces() takes them after the surfaces
// were sought from all seeds (seek_surface.h). Each changes the Partition of a mesh.
// Units: mm, rad; tolerance in mm.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "solid/mesh/patches.h"

namespace swept::step {

/// Makes grown patches ready to become faces: leftover triangles beside a patch join it, pieces of
/// one surface become one patch, islands inside a patch are filled, and patches that cost more
/// facets than they save are dropped. Every vertex of a patch stays within the tolerance of its
/// surface, except for a few small triangles where patches meet. Cost: O(triangles x rounds).
void tidyPatches(const HalfEdgeMesh& mesh, const TriangleShapes& shapes, double tolerance,
                 Partition& partition);

/// Makes extrusions and revolutions of open ground, and of patches whose simpler surface fits much
/// worse. Returns true if there are any. Cost: O(open triangles) if there are none.
bool seekProfiles(const HalfEdgeMesh& mesh, const TriangleShapes& shapes, double tolerance,
                  Partition& partition, RunContext& run);

/// Cuts patches that close on themselves round their surface, so that no face needs a seam. The
/// reference direction of each surface is turned so that its seam lies outside the face; where
/// there is no room for the seam, the patch is cut in halves, and Partition::cuts keeps the cutting
/// planes. Cost: O(triangles).
void cutRoundPatches(const HalfEdgeMesh& mesh, Partition& partition);

}  // namespace swept::step
