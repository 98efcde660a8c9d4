// Last step of mending: replaces all triangles of those cells in which triangles still intersect.
//
// In: a mended surface of consistent components, its grid, and the pairs that are left. Out: the
// same surface, closed and manifold, and the pairs that are left now.
// Units: mm. Cost: one pass over the triangles per round; microseconds per rebuilt cell.
// Promise: triangles in and between rebuilt cells do not intersect, up to rounding (cell_patch.h).
// If a triangle outside the rebuilt cells intersects them, the next round rebuilds its cells, too.
// Method: in a rebuilt cell, every piece of surface stays in the cell. It meets the cell's walls in
// the chords of its crossings, which do not cross. The polygons of these crossings become fans.
// In the other cells round such a crossing, the polygons keep their vertices. On the wall between
// such a cell and a rebuilt one, the polygons run through a point of the chord.
// Source: own method; points on faces after Ju and Udeshi 2006.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "contour/surface.h"
#include "geometry/self_intersections.h"

namespace swept {

/// Rebuilds cells of `surface` in place. Returns the pairs that are left, as its triangle indices.
/// Crossings may move by 0.0001 of a cell.
SelfIntersections rebuildCells(Surface& surface, const HermiteGrid& grid,
                               const SelfIntersections& found, RunContext& run);

}  // namespace swept
