// Self-intersections of an envelope, tested only where they can occur.
//
// In: the surface of the consistent components, and its grid. Out: all pairs of triangles that
// intersect, the same as findSelfIntersections() finds. Cost: one pass over the polygons, and exact
// tests for the few that fail the quick ones.
// Promise: complete. Let every cell have one vertex, inside it. For a lattice edge e and a face F
// beside it, the tetrahedron of e and the two vertices on either side of F lies in the two cells of
// F, and all such tetrahedra fill space without overlap. A fan about a crossing on e lies in the
// tetrahedra of e; so does a quad whose diagonal passes through the triangle of e and one of the
// other two corners. Such polygons therefore meet at common vertices and edges only. Each polygon
// is tested for this with a margin far above rounding. In a cell with several vertices a plane has
// to separate their polygons as well (crowded_cells.h). A polygon that fails, or whose vertex has
// left its cell, is compared exactly with everything near it.
// Source: Ju and Udeshi 2006, "Intersection-free contouring on an octree grid".
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "check/self_intersections.h"
#include "contour/surface.h"

namespace swept {

/// `unsure`, if given, receives the number of triangles that had to be compared exactly.
SelfIntersections findSurfaceIntersections(const Surface& surface, const HermiteGrid& grid,
                                           RunContext& run, std::int64_t* unsure = nullptr);

}  // namespace swept
