// Self-intersections of an envelope, found where they can be at all.
//
// In: the surface as the consistent components left it, and its grid. Out: every pair of triangles
// that meets, the same as findSelfIntersections() finds. Cost: one pass over the polygons.
// Why it is enough (after Ju and Udeshi 2006): let every cell have one vertex, inside it. For a
// lattice edge e and a face F beside it, the tetrahedron of e and the two vertices on either side
// of F lies in these two cells, and all such tetrahedra fill space without overlap. A fan about a
// crossing on e lies in those of e; so does a quad cut along a diagonal that passes through the
// triangle of e and one of the other two corners. Polygons of this kind therefore meet at common
// vertices and edges only. Each is tested for it with a margin far above rounding. In a cell with
// several vertices a plane has to part their polygons as well (crowded_cells.h). What fails, or
// has a vertex that has left its cell, is compared exactly with everything near it.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "contour/surface.h"
#include "geometry/self_intersections.h"

namespace swept {

/// `unsure`, if given, receives the number of triangles that had to be compared.
SelfIntersections findSurfaceIntersections(const Surface& surface, const HermiteGrid& grid,
                                           RunContext& run, std::int64_t* unsure = nullptr);

}  // namespace swept
