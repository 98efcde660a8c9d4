// Measures how far a mesh deviates from the solid that was made from it, and adds vertices where
// the deviation is too large.
// In:      the original vertices, the reduced mesh with its partition, and the positions of its
//          vertices in the model.
// Out:     the largest distance of a vertex from the nearest triangle, or from the surface that
//          replaces that triangle.
// Units:   mm.
// Cost:    O(n log n) for n vertices, parallel.
// Promise: The result does not depend on the number of threads.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "solid/mesh/decimate.h"

namespace swept::step {

struct Violation {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  std::int32_t triangle = -1;  ///< triangle of the reduced mesh
};

struct Deviation {
  double largest = 0;  ///< mm: the largest distance
  /// For each triangle, the vertex with the largest distance beyond the limit.
  std::vector<Violation> beyond;
};

Deviation measureDeviation(const std::vector<Eigen::Vector3d>& points, const Decimated& small,
                           const std::vector<Eigen::Vector3d>& positions, double limit);

/// Returns the points whose distance from the solid may change if vertices are inserted at these
/// positions.
std::vector<Eigen::Vector3d> pointsAbout(const std::vector<Violation>& corners,
                                         const Decimated& before, double limit,
                                         const std::vector<Eigen::Vector3d>& points);

/// Inserts each point as a vertex into its triangle, unless the triangle belongs to a recognised
/// surface or has just changed. Returns false if no point was inserted.
bool putCorners(const std::vector<Violation>& points, Decimated& small, RunContext& run);

}  // namespace swept::step
