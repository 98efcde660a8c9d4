// How far a mesh lies from the solid made of it, and corners put where that is too much.
// In: the mesh as given, the small mesh with its partition, and where the model has put its
// vertices. A vertex counts from the nearest triangle, or from the surface that stands for that
// triangle. Units: mm. Cost: O(n log n), parallel; the result does not depend on the threads.
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
  std::vector<Violation> beyond;  ///< by triangle: the vertex farthest beyond the limit
};

Deviation measureDeviation(const std::vector<Eigen::Vector3d>& points, const Decimated& small,
                           const std::vector<Eigen::Vector3d>& places, double limit);

/// Those of the points that new corners at these places can bring nearer or farther.
std::vector<Eigen::Vector3d> pointsAbout(const std::vector<Violation>& corners,
                                         const Decimated& before, double limit,
                                         const std::vector<Eigen::Vector3d>& points);

/// Open ground gets each of the points as a corner. False if none could be put in.
bool putCorners(const std::vector<Violation>& points, Decimated& small, RunContext& run);

}  // namespace swept::step
