// Measures the distance between two surfaces in both directions. On the original it measures at
// each vertex, and at points within those triangles that are not near a single triangle of the
// result. On the result it measures at a grid of points on each triangle. If triangles of the
// result change, only these are measured again, and the points of the original that were near them.
// Units:   mm.
// Cost:    O(n) searches in the trees of both surfaces, for n triangles. In most cases the triangle
//        that the previous search found is near enough.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "geometry/nearest_triangle.h"
#include "swept/types.h"

namespace swept {

/// A place where the surfaces are farther apart than the tolerance.
struct FarPoint {
  /// One of the two is the measured point, the other the point nearest to it.
  Eigen::Vector3d onOriginal = Eigen::Vector3d::Zero(), onResult = Eigen::Vector3d::Zero();
  std::int32_t triangle = -1;  ///< number of the triangle of the result
};

struct Deviation {
  /// mm, largest distance in either direction. Where a triangle that has changed is now nearer than
  /// the one found earlier, the earlier distance counts.
  double largest = 0;
  std::vector<FarPoint> missed;  ///< found at points of the original
  /// For each triangle of the result that is too far away, its farthest point; in ascending order
  /// of the triangles.
  std::vector<FarPoint> strays;
};

class DeviationMeter {
 public:
  /// `spacing` (mm): of the grid points. `nearOriginal` must be built with Walks::Yes. Keeps
  /// references to `original` and `nearOriginal`.
  DeviationMeter(const TriMesh& original, const NearestTriangle& nearOriginal, double spacing,
                 double tolerance);

  /// `numbers`: of the triangles of the result, in ascending order. A triangle that had the same
  /// number and corners in the previous call has not changed.
  Deviation measure(const TriMesh& result, const std::vector<std::int32_t>& numbers);

 private:
  // Successive vertices or triangles of the original.
  struct Block {
    bool isMeasured = false;
    double largest = 0;  // squared, mm^2
    std::vector<FarPoint> missed = {};
    std::vector<std::int32_t> near = {};  // numbers of the triangles near points within triangles
  };
  struct ResultTriangle {
    std::int32_t number;
    std::array<Eigen::Vector3d, 3> corners;
    bool isMeasured = false;
    double largest = 0;   // squared, mm^2
    FarPoint stray = {};  // if its number is not -1
  };
  class Forward;

  void takeResult(const TriMesh& result, const std::vector<std::int32_t>& numbers);
  void forgetBlocksNear(const std::vector<char>& hasChanged);
  void forgetAll();
  void measureOriginal(const TriMesh& result);
  void measureResult();
  // Squared distances up to this need not be measured exactly.
  double enough(double largest) const;

  const TriMesh& original_;
  const NearestTriangle& nearOriginal_;
  double spacing_, limit_;  // limit_: squared, mm^2
  std::size_t floor_ = 0;   // index in kFloors
  std::vector<Block> vertexBlocks_, triangleBlocks_;
  std::vector<std::int32_t> nearestOf_;  // by vertex of the original, a number
  std::vector<ResultTriangle> triangles_;
};

}  // namespace swept
