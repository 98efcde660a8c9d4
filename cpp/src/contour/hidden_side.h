// A side of the surface that no grid edge of the cell meets, between two that the crossings show:
// a ledge lower than a cell, the land at the end of a groove. The planes of the crossings then meet
// outside the cell, or nowhere. The crossings are parted into the two arcs of the component's ring
// that are flattest in themselves; lines from just outside the one to just inside the other meet
// the side that lies between them.
//
// Or the side between is known: all sides of a step are met by grid edges, but their planes meet in
// two features, not in one.
//
// With it known the cell has two features, the edges at which the hidden side begins and ends. The
// vertex is split where both lie in the cell, and goes to the one that does otherwise.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "contour/vertex_split.h"

namespace swept {

/// Looks for a side of the component between two others. False: none found, or none of its edges in
/// the cell.
/// `betweenPlanes`: not where the surface is curved, which explains planes that nearly meet.
bool findHiddenSide(const Cell& cell, const Eigen::Vector3i& at, const Components& components,
                    int component, const Crossing* crossings, const SurfaceProbe& probe,
                    bool betweenPlanes, VertexSplit& out);

}  // namespace swept
