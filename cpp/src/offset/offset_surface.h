// The surface at a distance from a cover, as marked edges and crossings on the lattice.
//
// In:    cover tree, field of gaps. Out: marked edges (for the signs), then for each contributing
//        one the exact crossing: point, normal and time.
// An edge is marked where its ends lie on different sides, or where both lie outside and the offset
// body dips in between (only looked for where it is less than two cells round).
// A crossing is where the line enters the union of rounded triangles (points within the distance of
// a triangle): each of them is convex, so Newton's method from outside reaches its skin without
// overshooting; from there a triangle that the line entered earlier is looked for, until none is
// left. Where the body is grown by less than half a cell, the line may pass walls apart from each
// other: all on the edge are queried. The normal points from the nearest point of that triangle.
// Units: cells. Cost: O(marked edges) queries.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "grid/hermite_grid.h"
#include "grid/marked_edges.h"
#include "offset/offset_field.h"

namespace swept::offset {

/// MarkedEdge::lowFraction = highFraction = where on the edge a point inside is known.
MarkedEdges markOffset(const OffsetField& field, const CoverSearch& tree, const GridPlan& grid,
                       RunContext& run);

/// The crossing of a marked edge seen from its low or high end.
Crossing offsetCrossing(const CoverSearch& tree, double distance, int axis, std::int32_t i,
                        std::int32_t j, const MarkedEdge& edge, bool fromLow);

}  // namespace swept::offset
