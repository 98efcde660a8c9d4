// How far two surfaces lie apart, both ways: every vertex of the original and points within those
// of its triangles that do not lie near one triangle of the result alone, and a net of points on
// the simplified triangles.
// Units: mm. Cost: O(n) questions to trees of either surface, mostly answered by the triangle that
// was found last.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/nearest_triangle.h"
#include "swept/types.h"

namespace swept {

struct Deviation {
  double largest = 0;                   ///< mm, of both directions
  std::vector<Eigen::Vector3d> missed;  ///< points of the original farther than `tolerance`
  std::vector<std::int32_t> strays;     ///< triangles of the result with such points, rising
};

/// `spacing`: mm, of the net. `nearOriginal` walks.
Deviation measureDeviation(const TriMesh& original, const NearestTriangle& nearOriginal,
                           const TriMesh& result, double spacing, double tolerance);

}  // namespace swept
