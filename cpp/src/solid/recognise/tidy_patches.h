// Makes grown patches ready to become faces.
// In, out: Partition of a mesh. Units: mm. Cost: O(triangles x rounds). Promise: every vertex of a
// patch stays within the tolerance of its surface, except for a few small triangles where patches
// meet.
// Leftover triangles beside a patch join it, pieces of one surface become one patch, islands inside
// a patch are filled, and patches that cost more facets than they save are dropped.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "solid/mesh/patches.h"

namespace swept::step {

void tidyPatches(const HalfEdgeMesh& mesh, const TriangleShapes& shapes, double tolerance,
                 Partition& partition);

}  // namespace swept::step
