// Distance of two triangles, of a point and a triangle, in double precision.
// In: corners, mm. Out: distance and the two nearest points. Cost: constant.
// Degenerate triangles (needles, points) are allowed: their edges still count. Edges that are
// nearly parallel, the normal case on machine parts, cost at most about 1e-8 of their length.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>

namespace swept::clearance {

using Corners = std::array<Eigen::Vector3d, 3>;

struct NearestPoints {
  double squared = 0;
  Eigen::Vector3d a = Eigen::Vector3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
};

NearestPoints nearestPoints(const Corners& a, const Corners& b);
Eigen::Vector3d nearestOnTriangle(const Eigen::Vector3d& point, const Corners& triangle);

}  // namespace swept::clearance
