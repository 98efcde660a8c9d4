// Mends self-intersections of an envelope where they are, without dropping a face.
//
// In: surface with the pairs of triangles that meet. Out: the same surface, closed and manifold as
// before, with the pairs that are left. Only polygons near a pair are touched, in rounds: they are
// fanned about their crossing (every triangle then stays in its own cells, Ju and Udeshi 2006), and
// the vertices of components that share their cell move towards their mass points, which lie in the
// hull of the crossings, half way and in later rounds all the way. In every other round the two
// sides of thin walls are laid together as well (wall_sides.h). In the end the polygons round the
// pairs' vertices are fanned too. A triangle spans at
// most the cells round one lattice edge, so it can only meet triangles a few cells away: the region
// looked at again is a few cells wider than what is changed. Cost: one pass over the triangles to
// find the region; then a round looks only at what is near the pairs that are left.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "contour/surface.h"
#include "geometry/self_intersections.h"

namespace swept {

/// Changes `surface` in place; returns the pairs that are left, by its triangle numbers. `grid` is
/// the one that it was contoured from.
SelfIntersections mendSelfIntersections(Surface& surface, const HermiteGrid& grid,
                                        const SelfIntersections& found, RunContext& run);

}  // namespace swept
