// Bounds how far a surface moves when a vertex is merged into a neighbour.
// In:      the neighbours of the vertex in order, relative to the vertex. Units: mm.
// Out:     a distance. Cost: O(k^2) for k neighbours.
// Method:  Seen along one direction, the triangles before and after the collapse do not overlap and
// cover the same polygon. So each point of the old surface moves along this direction to one point
// of the new surface. Between the edges of both surfaces, the distance is linear. So it is largest
// at the vertex, or where a new edge crosses an old one.
// Source:  Cohen, Manocha, Olano: Simplifying Polygonal Models Using Successive Mappings, 1997.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

namespace swept {

/// The vertex at the origin is merged into ring[0]. Returns the largest distance that a point of
/// the surface moves. `ring`: the neighbours of the vertex, counter-clockwise, three or more.
/// Returns infinity if the triangles before or after overlap, seen along their mean normal.
double mappedMove(const std::vector<Eigen::Vector3d>& ring);

}  // namespace swept
