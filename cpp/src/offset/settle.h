// Moves the vertices of a contoured offset surface to the requested distance.
//
// In:    vertices in mm, search of the nearest cover triangle, distance in cells.
// Out:   the vertices that must move, and their new positions in mm.
// Cost:  one query per vertex, a few more for each vertex that moves.
// Method: contouring places a vertex at the best point of the planes at the crossings of its cell.
//        An offset surface is round between these planes, so the vertex may lie too far out. If the
//        surface has a valley between the crossings, the vertex may lie too far in. A vertex that
//        is too far out moves straight towards its nearest point of the cover. This cannot bring it
//        too near to another part of the cover. A vertex that is too near moves straight away from
//        its nearest point of the cover. This step is repeated, because it may bring the vertex too
//        near to another part.
// Source: own method; for vertices that are too near, alternating projections (Bregman 1965).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "geometry/vertex_move.h"
#include "grid/grid_plan.h"
#include "offset/cover_search.h"
#include "swept/run_context.h"
#include "swept/types.h"

namespace swept::offset {

/// Returns the moves, in the order of `vertices` (the vertices to test). Returns no moves if the
/// distance is below half a cell, because a vertex may then lie on the wrong side of the cover.
std::vector<VertexMove> settlingMoves(const TriMesh& mesh,
                                      const std::vector<std::int32_t>& vertices,
                                      const CoverSearch& tree, double distance,
                                      const GridPlan& grid, RunContext& run);

}  // namespace swept::offset
