// Finds the end of a wall (or gap) thinner than a cell.
//
// In: a component with crossings on both sides of a thin wall, and a probe. Out: hits on the rim,
// and the split of the vertex into one for each side. Units: grid coordinates (cells). Cost: a few
// probe lines per wall end.
// Source: own method; docs/contouring.md, "Rims".
//
// No grid edge meets the rim of such a wall, so all crossings of the cell lie on its two sides.
// The plane half way between the sides cuts the edges of the cell in some points. Lines from the
// points outside the swept volume towards those inside hit the rim.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "contour/vertex_split.h"

namespace swept {

/// Looks for the rim of a thin wall that ends in this component. Returns false if there is none.
bool findWallEnd(const Cell& cell, const Eigen::Vector3i& at, const Components& components,
                 int component, const Crossing* crossings, const SurfaceProbe& probe,
                 VertexSplit& out);

}  // namespace swept
