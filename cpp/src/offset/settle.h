// Where the vertices of a contoured offset belong that are not at the distance asked for.
//
// In:    vertices in mm, distance to a cover. Out: those that have to move, and where to.
// Units: the distance in cells. Cost: a query a vertex, a few more for those that have to move.
// Method: a vertex is the best point of the planes at the crossings of its cell. An offset is round
//         between them, so that point may lie too far out, and where the cell hides a valley, too
//         far in. A vertex that is too far goes straight to its nearest point of the cover: no
//         other one comes nearer than asked by that. One that is too near goes straight away from
//         it, again and again, since that may bring it nearer to another one.
// Source: own method; alternating projections (Bregman 1965) for the second.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "geometry/vertex_move.h"
#include "grid/grid_plan.h"
#include "offset/cover_search.h"
#include "swept/run_context.h"
#include "swept/types.h"

namespace swept::offset {

/// Does nothing below a distance of half a cell, where a vertex may lie on the wrong side of the
/// cover. vertices: those to look at; the moves are in their order.
std::vector<VertexMove> settlingMoves(const TriMesh& mesh,
                                      const std::vector<std::int32_t>& vertices,
                                      const CoverSearch& tree, double distance,
                                      const GridPlan& grid, RunContext& run);

}  // namespace swept::offset
