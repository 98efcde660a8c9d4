// Polygons of mesh files -> triangles.
// In:   corners of one planar (or nearly planar) polygon, convex or not, counter-clockwise.
// Out:  n - 2 triangles over the same corners and boundary edges, in the polygon's own sense.
// Cost: O(n^2), ear clipping in the plane of Newell's normal; what cannot be clipped is fanned.
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
