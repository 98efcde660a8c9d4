// Aligns the two sides of walls so thin that their triangles intersect.
//
// In: a surface, its grid, and the triangles round the vertices. Out: the same triangles with moved
// vertices. Units: mm; thickness in cells. Cost: some microseconds per pair.
// Source: own method; directions by Badoiu and Clarkson 2003, "Smaller core-sets for balls".
//
// If a wall is thinner than the error of the vertices on its two sides, the sides may cross. Two
// vertices of one cell whose polygons intersect are first moved onto one common point. Then they
// are moved apart, along a direction that is outward for all triangles round them. Their new
// distance is the thickness of the wall, measured on the lattice edges that pass through it. The
// two polygons round such a lattice edge are then the two faces of one sheet, which cannot cross.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "contour/surface.h"
#include "geometry/self_intersections.h"

namespace swept {

/// Sorted pairs (vertex, triangle). The triangle has the vertex as a corner and belongs to the
/// polygon of a crossing.
using TrianglesAround = std::vector<std::pair<std::int32_t, std::int32_t>>;

/// Returns the crossings whose polygons meet in a vertex, in ascending order.
std::vector<std::uint32_t> crossingsAt(const Surface& surface, const TrianglesAround& around,
                                       std::int32_t vertex);

/// Two component vertices of one cell, one on each side of the wall.
struct WallSides {
  std::int32_t a, b;
};

/// Returns pairs of vertices of one cell whose triangles intersect. No vertex occurs twice.
std::vector<WallSides> wallSides(const Surface& surface, const SelfIntersections& pairs);

/// Moves the two vertices of each pair to the two sides of its wall. A pair does not move if no
/// lattice edge passes through its wall, or if the wall is thicker than `maxThickness` cells along
/// one of these edges.
void alignWallSides(Surface& surface, const HermiteGrid& grid, const std::vector<WallSides>& sides,
                    const TrianglesAround& around, double maxThickness);

}  // namespace swept
