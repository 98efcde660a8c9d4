// Leaves triangles out of a surface, with the vertices that nothing uses any more.
// Cost: O(triangles + vertices).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "contour/surface.h"
#include "geometry/self_intersections.h"

namespace swept {

/// keeps: per triangle, 0 to leave it out. The order of what is kept stays; so do the pairs of
/// which both triangles are kept, by their new numbers.
void keepTriangles(Surface& surface, const std::vector<std::uint8_t>& keeps,
                   SelfIntersections& pairs);

}  // namespace swept
