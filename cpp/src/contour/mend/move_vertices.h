// Moves vertices of a surface as far as no triangles meet by that.
// In:    a surface without pairs of triangles that meet; where vertices are to go.
// Out:   the surface, still without pairs; vertices whose triangles would meet others, or lose
// their
//        area, have gone half of the way, or stay.
// Units: mm. Cost: one pass over the triangles, then what lies near the moved ones, a few times.
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
