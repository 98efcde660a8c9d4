// The end of a wall (or gap) thinner than a cell: no grid edge meets its rim, so that the crossings
// of the cell know its two sides only. The plane half way between the sides is cut with the cell;
// from the corners of this cut that lie outside, the surface is probed towards those inside.
//
// A wall end with its rim found has two features, one for each side.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "contour/vertex_split.h"

namespace swept {

/// Looks whether the component is the end of a thin wall, and for its rim. False: no rim found.
bool findWallEnd(const Cell& cell, const Eigen::Vector3i& at, const Components& components,
                 int component, const Crossing* crossings, const SurfaceProbe& probe,
                 VertexSplit& out);

}  // namespace swept
