// Removes triangles from a surface, and the vertices that no triangle uses any more.
//
// Cost: O(triangles + vertices).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "contour/surface.h"
#include "geometry/self_intersections.h"

namespace swept {

/// Removes every triangle t with keeps[t] == 0. The remaining triangles and vertices keep their
/// order. `pairs` keeps the pairs whose triangles both remain, with their new numbers.
void keepTriangles(Surface& surface, const std::vector<std::uint8_t>& keeps,
                   SelfIntersections& pairs);

}  // namespace swept
