// Cuts flat polygons with holes into triangles.
//
// In: closed loops of points that lie in one plane up to rounding. Seen from the normal, outer
// loops run counter-clockwise and holes clockwise. Out: triangles over the same points.
// Cost: O(n log n) to O(n^2) for n points. The polygons of shared volumes (overlap/) have a few
// points, seldom thousands.
// Promise: for any coordinates, the triangles contain every edge of the loops once, in its
// direction, and every other edge once in each direction. A closed surface therefore stays closed.
// If rounding makes loops cross themselves, triangles may overlap.
// Source: D. Eberly, Triangulation by ear clipping (2002). A hole is joined to its loop by two
// edges along one line.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace swept {

using Loop = std::vector<std::int32_t>;

/// Cuts the polygon with these loops into triangles, and appends them to `triangles`. The loops
/// hold indices of `points`.
void cutIntoTriangles(const std::vector<Loop>& loops, const std::vector<Eigen::Vector3d>& points,
                      const Eigen::Vector3d& normal,
                      std::vector<std::array<std::int32_t, 3>>& triangles);

}  // namespace swept
