// Splits polygons of mesh files into triangles.
// In:   corners of one polygon, planar or nearly so, convex or not, counter-clockwise.
// Out:  n - 2 triangles with the same corners, boundary edges and orientation.
// Cost: O(n^2). Method: ear clipping in the plane of Newell's normal. If no ear is left, the next
//       corner is clipped.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "swept/types.h"

namespace swept {

void splitPolygon(const std::vector<Eigen::Vector3d>& vertices,
                  std::span<const std::int32_t> corners,
                  std::vector<std::array<std::int32_t, 3>>& triangles);

}  // namespace swept
