// Finds polygons that may intersect in cells with several vertices.
//
// In: a surface, its grid, and a mark per crossing (1: its polygon lies in the tetrahedra of its
// own lattice edge, see surface_intersections.h). Out: pairs of marked polygons that may intersect.
// These are two polygons of different vertices of one cell that no tested plane separates, or two
// polygons of one lattice edge that share a vertex. Cost: some dot products per cell with several
// vertices.
// Promise: no pair is missing. Two polygons that intersect have a cell in common. If they use the
// same vertex in all common cells, they lie in tetrahedra that do not overlap, unless both belong
// to one lattice edge. If they use different vertices of a cell, the pair is reported unless a
// plane separates the two whole polygons.
// Source: extends Ju and Udeshi 2006, "Intersection-free contouring on an octree grid", to several
// vertices per cell.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "contour/mend/polygons.h"
#include "swept/run_context.h"

namespace swept {

/// Each pair lists its smaller crossing first. The pairs are in ascending order.
using CrossingPairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

CrossingPairs entangledPolygons(const Surface& surface, const HermiteGrid& grid,
                                const Polygons& polygons, const std::vector<std::uint8_t>& marks,
                                RunContext& run);

}  // namespace swept
