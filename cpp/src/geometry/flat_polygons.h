// Flat polygons with holes, cut into triangles.
// In:    closed loops of points that lie in one plane but for rounding. Seen from the normal,
//        outer loops run counter-clockwise, holes clockwise. Out: triangles over the same points.
// Cost:  O(n log n) to O(n^2) for n points; one of a shared volume has a handful, seldom thousands.
// Promise: whatever the numbers are, the triangles pass every edge of the loops once in its
//        direction, and every other edge once each way: what is closed stays closed. Where rounding
//        makes loops cross themselves, triangles may lie on one another.
// Source: D. Eberly, Triangulation by ear clipping (2002): holes are joined to their loop by two
//        edges along one line.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace swept {

using Loop = std::vector<std::int32_t>;

/// points: all that the loops refer to; triangles are appended.
void cutIntoTriangles(const std::vector<Loop>& loops, const std::vector<Eigen::Vector3d>& points,
                      const Eigen::Vector3d& normal,
                      std::vector<std::array<std::int32_t, 3>>& triangles);

}  // namespace swept
