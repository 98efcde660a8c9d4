// How far two surfaces lie apart, both ways, at sample points: vertices and middles of the
// triangles of the original, a net of points about a cell apart on the simplified triangles.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "geometry/nearest_triangle.h"

namespace swept {

struct DeviationInput {
  const std::vector<Eigen::Vector3d>& originalPoints;
  const std::vector<std::array<std::int32_t, 3>>& originalTriangles;
  const std::vector<std::uint8_t>& creased;  ///< per original triangle: not flat round it
  const NearestTriangle& original;
  const std::vector<Eigen::Vector3d>& points;
  const std::vector<std::array<std::int32_t, 3>>& triangles;
  double tolerance = 0;
  double known = 0;  ///< a distance that some point of the original is known to have
};

struct Deviation {
  double forward = 0, backward = 0;     ///< cells
  std::vector<std::int32_t> triangles;  ///< of the result that lie beyond the tolerance
  std::vector<std::int32_t> vertices;   ///< of the original that lie beyond the tolerance
  double largest() const { return forward > backward ? forward : backward; }
};

Deviation measureDeviation(const DeviationInput& in);

}  // namespace swept
