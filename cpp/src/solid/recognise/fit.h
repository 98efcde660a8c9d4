// Elementary surface through points with normals: a linear first guess, then least squares on the
// true distances.
// In: points (mm), outward unit normals. Out: Surface with `reversed` set from the normals.
// Cost: O(points).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "solid/carrier/surface.h"

namespace swept::step {

struct Samples {
  std::vector<Eigen::Vector3d> points;
  std::vector<Eigen::Vector3d> normals;
};

/// First guess; nothing where the samples do not determine the surface.
std::optional<Surface> guessSurface(SurfaceKind kind, const Samples& samples);

/// Least squares on the distances of the points (at most about `most` of them are used).
void refineSurface(const Samples& samples, Surface& surface, std::size_t most = 240);

/// Largest and median absolute distance of the points.
struct Residuals {
  double largest = 0, median = 0;
};
Residuals residuals(const Samples& samples, const Surface& surface);

}  // namespace swept::step
