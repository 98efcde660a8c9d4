// The two sides of walls so thin that their triangles meet.
//
// Where a wall is thinner than what its two sides' vertices are off their place, the sides cross.
// Two vertices of one cell whose polygons meet are moved onto one place between them and from
// there apart again, along a direction that all triangles round both agree with, by half of what
// the lattice edges through the wall say about its thickness. Polygons about one lattice edge then
// are the two faces of one sheet, which cannot cross.
// In: surface, its grid, triangles round the vertices. Out: moved vertices; faces stay as they are.
// Cost: some microseconds a pair.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "contour/surface.h"
#include "geometry/self_intersections.h"

namespace swept {

/// Vertex, and a triangle at it that is part of a crossing's polygon; sorted.
using TrianglesAround = std::vector<std::pair<std::int32_t, std::int32_t>>;

/// Two component vertices of one cell, each on a side of its own.
struct FacingSides {
  std::int32_t a, b;
};

/// Those to which triangles belong that meet; no vertex twice.
std::vector<FacingSides> facingSides(const Surface& surface, const SelfIntersections& pairs);

/// Lays both vertices of each pair side by side; pairs without a common lattice edge stay, and
/// those with more than `thickest` cells between them along one.
void layTogether(Surface& surface, const HermiteGrid& grid, const std::vector<FacingSides>& sides,
                 const TrianglesAround& around, double thickest);

}  // namespace swept
