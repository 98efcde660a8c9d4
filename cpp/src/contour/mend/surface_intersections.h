// Finds self-intersections of an envelope, testing only where they can occur.
//
// In: the surface of the consistent components, and its grid. Out: all pairs of triangles that
// intersect, the same as findSelfIntersections() finds. Cost: one pass over the polygons, and exact
// tests for the few that fail the quick test.
// Promise: complete. Assume first that every cell has one vertex, which lies inside the cell. A
// lattice edge e and a face F beside e define a tetrahedron: its corners are the ends of e and the
// vertices of the two cells at F. The tetrahedron lies in these two cells, and all such tetrahedra
// fill space without overlap. A fan about a crossing on e lies in the tetrahedra of e. So does a
// quad whose diagonal passes through the triangle of e and one of the other two corners. Polygons
// that lie in the tetrahedra of their own edges therefore meet at common vertices and edges only.
// The test of each polygon has a margin far above rounding. In a cell with several vertices, a
// plane must separate the polygons of different vertices as well (crowded_cells.h). A polygon that
// fails a test, or whose vertex has left its cell, is compared exactly with all triangles near it.
// Source: Ju and Udeshi 2006, "Intersection-free contouring on an octree grid".
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "contour/surface.h"
#include "geometry/self_intersections.h"

namespace swept {

/// Finds all pairs. `unsure`, if given, receives the number of triangles that needed exact tests.
SelfIntersections findSurfaceIntersections(const Surface& surface, const HermiteGrid& grid,
                                           RunContext& run, std::int64_t* unsure = nullptr);

}  // namespace swept
