// Mends self-intersections of an envelope locally, without removing a face.
//
// In: a surface and its pairs of intersecting triangles. Out: the same surface, still closed and
// manifold, and the pairs that are left. Units: mm, distances as fractions of the cell. Cost: one
// pass over the triangles to find the region round the pairs. After that, each round tests only
// triangles near the remaining pairs.
// Promise: only polygons near a pair change. The number of rounds has a fixed limit, so the result
// does not depend on time or threads.
// Source: fans about the crossing after Ju and Udeshi 2006; docs/contouring.md, "Pairs of triangles
// that intersect".
//
// Each round replaces polygons near a pair by fans about their crossing. Every triangle then stays
// in the cells round its lattice edge. Each round also moves the vertices of components that share
// a cell towards their mass points, which lie in the hull of their crossings: half way in the first
// round, the whole way in later rounds. Every other round also aligns the two sides of thin walls
// (wall_sides.h). Later rounds also replace the other polygons round the vertices of the pairs by
// fans. A triangle lies within the cells round one lattice edge, so it can only intersect triangles
// a few cells away. The region that is tested again extends beyond the changed triangles by this
// distance.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "contour/surface.h"
#include "geometry/self_intersections.h"

namespace swept {

/// Mends `surface` in place. Returns the pairs that are left, as its triangle indices. `surface`
/// must have been contoured from `grid`.
SelfIntersections mendSelfIntersections(Surface& surface, const HermiteGrid& grid,
                                        const SelfIntersections& found, RunContext& run);

}  // namespace swept
