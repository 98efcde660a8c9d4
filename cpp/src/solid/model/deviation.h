// How far a mesh lies from the solid made of it, and new corners where that is too far.
// In: the given mesh, the small mesh with its partition, and the positions that the model gave its
// vertices. Out: the largest distance of a vertex from the nearest triangle, or from the surface
// that replaces that triangle. Units: mm. Cost: O(n log n), parallel. Promise: the same for any
// number of threads.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "solid/mesh/decimate.h"

namespace swept::step {

struct Violation {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  std::int32_t triangle = -1;  ///< of the small mesh
};

struct Deviation {
  double largest = 0;             ///< mm
  std::vector<Violation> beyond;  ///< per triangle: the vertex farthest beyond the limit
};

Deviation measureDeviation(const std::vector<Eigen::Vector3d>& points, const Decimated& small,
                           const std::vector<Eigen::Vector3d>& positions, double limit);

/// Those of the points whose distance new corners at these positions can change.
std::vector<Eigen::Vector3d> pointsAbout(const std::vector<Violation>& corners,
                                         const Decimated& before, double limit,
                                         const std::vector<Eigen::Vector3d>& points);

/// Makes each of the points a corner of open ground. Returns false if none could be added.
bool putCorners(const std::vector<Violation>& points, Decimated& small, RunContext& run);

}  // namespace swept::step
