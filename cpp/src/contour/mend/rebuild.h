// The last step of mending: cells whose triangles still meet are filled anew, so that they cannot.
//
// In:    a mended surface of consistent components, its grid, the pairs that are left. Out: the
//        same surface, closed and manifold, and the pairs that are left now.
// Units: mm. Cost: one pass over the triangles a round; microseconds a cell that is rebuilt.
// Promise: nothing in or between rebuilt cells meets, up to rounding (cell_patch.h). Where
//        something outside meets them, its cells are rebuilt in the next round.
// Method: in a rebuilt cell every piece of surface stays in the cell and meets its walls in the
//        chords of its crossings, which do not cross. The polygons of its crossings become fans;
//        in the other cells beside such a crossing they keep their vertices, and run through a
//        point of the chord on the wall of the rebuilt cell.
// Source: own method; points on faces after Ju and Udeshi 2006.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "contour/surface.h"
#include "geometry/self_intersections.h"

namespace swept {

/// Changes `surface` in place and returns the pairs that are left, by its triangle numbers.
/// Crossings may move by 0.0001 of a cell.
SelfIntersections rebuildCells(Surface& surface, const HermiteGrid& grid,
                               const SelfIntersections& found, RunContext& run);

}  // namespace swept
