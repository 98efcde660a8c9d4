// The end of a wall (or gap) thinner than a cell: no grid edge meets its rim, so that the crossings
// of the cell know its two sides only. The plane half way between the sides is cut with the cell;
// from the corners of this cut that lie outside, the surface is probed towards those inside.
//
// A wall end with its rim found has two features: the vertex is split, one for each side, and a
// strip of rim polygons joins the two (METHOD: more than one feature in a component).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <vector>

#include "contour/components.h"
#include "data/surface_probe.h"

namespace swept {

struct WallEnd {
  /// Per slot of the component: 0 the one side of the wall, 1 the other, -1 neither.
  std::array<std::int8_t, kSlots> side;
  std::vector<ProbeLine> rim;  ///< hits, in grid coordinates
  /// Where the polygons of the two sides meet: the pairs of slots on the cell's faces. Two of them,
  /// or none if the vertex cannot be split.
  std::vector<std::array<std::int8_t, 2>> folds;
  std::vector<std::int8_t> foldFaces;
};

/// Looks whether the component is the end of a thin wall, and for its rim. False: no rim found.
bool findWallEnd(const Cell& cell, const Eigen::Vector3i& at, const Components& components,
                 int component, const Crossing* crossings, const SurfaceProbe& probe, WallEnd& out);

}  // namespace swept
