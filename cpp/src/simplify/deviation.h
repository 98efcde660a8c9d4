// Measures the distance between two surfaces in both directions. On the original it measures at
// each vertex, and at points within those triangles that are not near a single triangle of the
// result. On the result it measures at a grid of points on each triangle.
// Units:   mm.
// Cost:    O(n) searches in the trees of both surfaces, for n triangles. In most cases the triangle
//        that the previous search found is near enough.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/nearest_triangle.h"
#include "swept/types.h"

namespace swept {

/// A place where the surfaces are farther apart than the tolerance.
struct FarPoint {
  /// One of the two is the measured point, the other the point nearest to it.
  Eigen::Vector3d onOriginal, onResult;
  std::int32_t triangle = -1;  ///< triangle of the result
};

struct Deviation {
  double largest = 0;            ///< mm, largest distance in either direction
  std::vector<FarPoint> missed;  ///< found at points of the original
  /// For each triangle of the result that is too far away, its farthest point; in ascending order
  /// of the triangles.
  std::vector<FarPoint> strays;
};

/// Measures the deviation. `spacing` (mm) is the distance of the grid points. `nearOriginal` must
/// be built with Walks::Yes.
Deviation measureDeviation(const TriMesh& original, const NearestTriangle& nearOriginal,
                           const TriMesh& result, double spacing, double tolerance);

}  // namespace swept
