// Computes the surface at a given distance from a cover, as marked edges and crossings on the
// lattice. The offset body is the union of the grown triangles. A grown triangle consists of all
// points within `distance` plus slack of a cover triangle.
//
// In:    cover search, field of gaps.
// Out:   marked edges, from which the signs follow; then, for each contributing edge, the exact
//        crossing: point, normal and time.
// Method: an edge is marked if its ends lie on different sides. It is also marked if both ends lie
//        outside, but the offset body contains a point of the edge (a dip). Dips are only searched
//        for if the distance is below two cells. A crossing is the point at which the grid line
//        enters the offset body. Every grown triangle is convex, so Newton's method from outside
//        reaches its surface without overshooting. From there, the search looks for another grown
//        triangle that the line enters earlier, until there is none. If the distance is below half
//        a cell, the line may pass through separate walls. Then all triangles near the edge are
//        tested. The normal points away from the nearest point of the triangle.
// Units: cells. Cost: O(marked edges) queries.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "grid/hermite_grid.h"
#include "grid/marked_edges.h"
#include "offset/offset_field.h"

namespace swept::offset {

/// Sets lowFraction and highFraction of each marked edge to the position of a known inside point.
MarkedEdges markOffset(const OffsetField& field, const CoverSearch& tree, const GridPlan& grid,
                       RunContext& run);

/// Returns the crossing of a marked edge as seen from its low or high end.
Crossing offsetCrossing(const CoverSearch& tree, double distance, int axis, std::int32_t i,
                        std::int32_t j, const MarkedEdge& edge, bool fromLow);

}  // namespace swept::offset
