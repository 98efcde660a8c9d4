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

/// Where the surfaces lie farther apart than the tolerance.
struct FarPlace {
  Eigen::Vector3d onOriginal, onResult;  ///< one is nearest to the other
  std::int32_t triangle = -1;            ///< of the result
};

struct Deviation {
  double largest = 0;            ///< mm, of both directions
  std::vector<FarPlace> missed;  ///< points of the original
  std::vector<FarPlace> strays;  ///< the farthest points of triangles of the result, these rising
};

/// `spacing`: mm, of the net. `nearOriginal` walks.
Deviation measureDeviation(const TriMesh& original, const NearestTriangle& nearOriginal,
                           const TriMesh& result, double spacing, double tolerance);

}  // namespace swept
