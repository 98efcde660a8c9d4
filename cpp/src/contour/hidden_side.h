// Sides of the surface that no grid edge of a cell meets.
//
// In: a component whose planes have no common point in the cell, and a probe that casts lines at
// the swept surface. Out: the side between, and the split of the vertex if both of its edges lie in
// the cell. Units: grid coordinates (cells). Cost: some lines per cell that is probed.
// Source: own method; figures in docs/contouring.md, "Hidden sides" and "Known sides".
//
// Between two sides that the crossings show there can be a third one that no grid edge meets: the
// riser of a ledge lower than a cell, or the floor of a groove that ends. The component's ring is
// cut into its two flattest arcs; lines from just outside the one to just inside the other hit the
// side between them. Or the side is known already: the grid edges meet all three sides of a step,
// but their planes meet in two features instead of one.
//
// With the side known, the cell has two features: the edges at which that side begins and ends. The
// vertex is split if both lie in the cell; otherwise it moves to the one that does.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "contour/vertex_split.h"

namespace swept {

/// Looks for a side of the component between two others. Returns false if there is none, or none of
/// its edges lies in the cell. `betweenPlanes`: only where the known sides are flat; planes of a
/// curved surface may miss each other without a hidden side.
bool findHiddenSide(const Cell& cell, const Eigen::Vector3i& at, const Components& components,
                    int component, const Crossing* crossings, const SurfaceProbe& probe,
                    bool betweenPlanes, VertexSplit& out);

}  // namespace swept
