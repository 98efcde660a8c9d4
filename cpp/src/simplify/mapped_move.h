// Bounds how far a surface moves when a vertex is merged into a neighbour.
// In:      the neighbours of the vertex in order, seen from it. Units: mm.
// Out:     a distance. Cost: O(k^2) for k neighbours.
// Method:  Seen along one direction, the triangles before and after the collapse lie side by side
//          and cover the same polygon. So each point of the old surface moves along this direction
//          to one point of the new surface. The distance is linear between the edges of both. It is
//          largest at the vertex, or where a new edge crosses an old one.
// Source:  Cohen, Manocha, Olano: Simplifying Polygonal Models Using Successive Mappings, 1997.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

namespace swept {

/// Returns the largest distance that a point of the surface moves when the vertex at the origin is
/// merged into ring[0]. `ring`: its neighbours, counter-clockwise, three or more. Returns infinity
/// if the triangles before or after overlap, seen along their mean normal.
double mappedMove(const std::vector<Eigen::Vector3d>& ring);

}  // namespace swept
