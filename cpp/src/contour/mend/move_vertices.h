// Moves vertices of a surface to target positions, without making pairs of triangles that
// intersect.
//
// In: a surface without intersecting triangles, and the target positions of vertices. Out: the
// surface, still without intersections. A vertex moves only half of the distance, or not at all, if
// its triangles would otherwise intersect others or lose their area.
// Units: mm. Cost: one pass over the triangles, then a few passes over those near the moved
// vertices.
// Promise: the same bytes for any number of threads.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "contour/surface.h"
#include "geometry/vertex_move.h"

namespace swept {

void moveWithoutPairs(Surface& surface, const GridPlan& plan, const std::vector<VertexMove>& moves,
                      RunContext& run);

}  // namespace swept
