// Fills the pieces of surface in one cell with triangles that do not intersect.
//
// In: the rings of the cell (cell_rings.h), the points on the rings, and preferred positions of
// their vertices. Out: triangles that fill every ring inside the cell, and the points that they
// add. Cost: microseconds per cell.
// Promise: triangles of one cell share nothing but corners and edges of their own ring, and stay in
// the cell.
// Method: each ring is filled by a fan about one vertex if an exact test finds no two fans that
// intersect. Otherwise all rings are shrunk towards one common point of the cell. Seen from this
// point, no two points of the cell's walls lie in the same direction, so the shrinking rings sweep
// surfaces that do not intersect. Each ring ends as a small copy of itself, on the walls of a small
// copy of the cell. The copy is filled with that part of the small cell's walls that lies on one
// side of the copy. If rings are nested, an outer ring ends at a smaller copy of the cell than the
// rings inside it.
// Source: own method.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "contour/mend/cell_rings.h"

namespace swept {

/// One ring and its vertex, in mm.
struct PatchRing {
  /// The crossings of the ring, each followed by the point on the chord to the next crossing.
  std::vector<Eigen::Vector3d> points;
  std::vector<Eigen::Vector3d> vertices;  ///< preferred positions of the vertex, the best first
};

struct CellPatch {
  std::vector<Eigen::Vector3d> added;  ///< positions of the added points, mm
  std::vector<std::size_t> ringOf;     ///< per added point: index of its ring
  /// The corner indices count the points of all rings first, then the points of `added`.
  std::vector<std::array<std::int32_t, 3>> triangles;
  std::vector<std::int8_t> slotOf;  ///< per triangle: the slot of its crossing
  bool layered = false;  ///< true: all choices of fans intersect, so the rings were shrunk
};

/// Position and size of a cell, in mm.
struct CellBox {
  Eigen::Vector3d corner;  ///< its low corner
  double size;
  Eigen::Vector3d toWorld(const Eigen::Vector3d& local) const { return corner + size * local; }
  Eigen::Vector3d toLocal(const Eigen::Vector3d& world) const { return (world - corner) / size; }
};

/// Fills the rings of a cell. `rings` and `points` have the same order.
CellPatch patchOf(const Cell& cell, const Crossing* crossings, const std::vector<CellRing>& rings,
                  const std::vector<PatchRing>& points, const CellBox& box);

}  // namespace swept
