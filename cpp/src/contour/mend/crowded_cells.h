// Cells with several vertices: which of their polygons may meet.
//
// In: a surface, its grid, and which polygons lie in the tetrahedra of their own lattice edge with
// the vertices that are theirs (by crossing, 1: yes). Out: every pair of such polygons that may
// meet at all: those of two vertices of one cell between which no plane was found, and the two of
// one lattice edge that share a vertex. Cost: some dot products a crowded cell. Why it is enough:
// two polygons that meet have a cell in common. With the same vertex in all common cells they lie
// in tetrahedra that do not overlap, unless these are those of one lattice edge; where their
// vertices differ they are told unless a plane parts them as a whole.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "contour/mend/polygons.h"
#include "swept/run_context.h"

namespace swept {

/// Smaller crossing first, in rising order.
using CrossingPairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

CrossingPairs entangledPolygons(const Surface& surface, const HermiteGrid& grid,
                                const Polygons& polygons, const std::vector<std::uint8_t>& marks,
                                RunContext& run);

}  // namespace swept
