// Finds sides of the surface that no grid edge of a cell meets.
//
// In: a component whose planes have no common point in the cell, and a probe that casts lines at
// the swept surface. Out: hits on the hidden side, and the split of the vertex if both edges of
// that side lie in the cell. Units: grid coordinates (cells). Cost: a few lines per cell that is
// probed.
// Source: own method; figures in docs/contouring.md, "Hidden sides" and "Known sides".
//
// The crossings of a cell may lie on two sides of the surface, with a third side between them that
// no grid edge meets. Examples are the riser of a step lower than a cell, and the floor of a groove
// that ends. The search cuts the component's ring of crossings into its two flattest arcs. Lines
// from just outside one arc to just inside the other hit the side between them. In another case,
// the third side is known: grid edges meet all three sides of a step, but the planes of the sides
// meet in two edges instead of one corner.
//
// The third side begins and ends at an edge. If both edges lie in the cell, the vertex is split
// into one for each edge. If only one edge lies in the cell, the vertex moves to this edge.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "contour/vertex_split.h"

namespace swept {

/// Looks for three successive sides of the component, such as those of a step. Grid edges meet all
/// of them, and the middle one forms an edge with each of the others in the cell. If the outer two
/// are the sides of a thin wall, the middle one is its rim. Returns false, and leaves `out`
/// unchanged, if there are no such sides.
bool findKnownSide(const Cell& cell, const Eigen::Vector3i& at, const Components& components,
                   int component, const Crossing* crossings, const SurfaceProbe& probe,
                   VertexSplit& out);

/// Looks for a side that no grid edge meets, between two other sides of the component. Returns
/// false if there is none, or if no edge of this side lies in the cell. With `betweenPlanes`, looks
/// only between two flat arcs, because the planes of a curved surface may have no common point even
/// without such a side.
bool findHiddenSide(const Cell& cell, const Eigen::Vector3i& at, const Components& components,
                    int component, const Crossing* crossings, const SurfaceProbe& probe,
                    bool betweenPlanes, VertexSplit& out);

}  // namespace swept
