// Triangles for the pieces of surface in one cell that cannot meet.
//
// In:    the rings of the cell (cell_rings.h) with the points that they pass; where the vertices
//        are wanted. Out: triangles that fill every ring inside the cell, and the points that they
//        add.
// Cost:  microseconds a cell.
// Promise: triangles of one cell have nothing in common but corners and edges of their own ring,
//        and stay in the cell.
// Method: a ring is filled by a fan about one vertex where no two fans meet, as tested exactly.
//        Seen from any point in a convex cell, each point of its walls lies in another direction.
//        So all rings can be drawn together towards one common point without meeting, and end at
//        small copies of themselves on the walls of small copies of the cell. There each one is
//        filled by the part of these walls that lies on one side of it; where rings lie within
//        each other, the outer one goes on to a smaller copy than the inner one.
// Source: own method.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "contour/mend/cell_rings.h"

namespace swept {

/// All in mm.
struct PatchRing {
  std::vector<Eigen::Vector3d> points;  ///< a crossing, the point on the chord behind it, and so on
  std::vector<Eigen::Vector3d> vertices;  ///< where the vertex is wanted, the best place first
};

struct CellPatch {
  std::vector<Eigen::Vector3d> added;  ///< mm
  std::vector<std::size_t> ringOf;     ///< per point of `added`
  /// Corners are numbered through the points of all rings, then through `added`.
  std::vector<std::array<std::int32_t, 3>> triangles;
  std::vector<std::int8_t> slotOf;  ///< per triangle: the crossing that it belongs to
  bool layered = false;             ///< no fans were found that do not meet
};

/// Where a cell lies, in mm.
struct CellPlace {
  Eigen::Vector3d corner;  ///< its low corner
  double size;
  Eigen::Vector3d toWorld(const Eigen::Vector3d& local) const { return corner + size * local; }
  Eigen::Vector3d toLocal(const Eigen::Vector3d& world) const { return (world - corner) / size; }
};

/// rings and points: in the same order.
CellPatch patchOf(const Cell& cell, const Crossing* crossings, const std::vector<CellRing>& rings,
                  const std::vector<PatchRing>& points, const CellPlace& place);

}  // namespace swept
