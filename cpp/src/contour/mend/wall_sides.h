// Aligns the two sides of walls so thin that their triangles intersect.
//
// In: surface, its grid, the triangles round the vertices. Out: moved vertices; the faces stay as
// they are. Units: mm; thickness in cells. Cost: some microseconds per pair.
// Source: own method; directions by Badoiu and Clarkson 2003, "Smaller core-sets for balls".
//
// Where a wall is thinner than the error of the vertices on its two sides, the sides cross. Two
// vertices of one cell whose polygons intersect are moved onto one common point, and then apart
// again along a direction that all triangles round them agree with, by half the thickness that the
// lattice edges through the wall show. The polygons round such a lattice edge then are the two
// faces of one sheet, which cannot cross.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "contour/surface.h"
#include "geometry/self_intersections.h"

namespace swept {

/// Pairs of a vertex and a triangle at it that belongs to a crossing's polygon; sorted.
using TrianglesAround = std::vector<std::pair<std::int32_t, std::int32_t>>;

/// The crossings whose polygons meet in a vertex, in rising order.
std::vector<std::uint32_t> crossingsAt(const Surface& surface, const TrianglesAround& around,
                                       std::int32_t vertex);

/// Two component vertices of one cell, one on each side of the wall.
struct WallSides {
  std::int32_t a, b;
};

/// The vertex pairs whose triangles intersect; no vertex occurs twice.
std::vector<WallSides> wallSides(const Surface& surface, const SelfIntersections& pairs);

/// Moves both vertices of each pair side by side. Pairs without a common lattice edge stay, as do
/// those whose wall is thicker than `maxThickness` cells along one of these edges.
void alignWallSides(Surface& surface, const HermiteGrid& grid, const std::vector<WallSides>& sides,
                    const TrianglesAround& around, double maxThickness);

}  // namespace swept
