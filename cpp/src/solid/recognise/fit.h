// Fits an elementary surface to points with normals: a linear first guess, then least squares on
// the exact distances.
// In:      points, outward unit normals.
// Out:     a surface, with `reversed` set from the normals.
// Units:   mm.
// Cost:    O(points).
// Source:  axes from the linear complex of the normals (Pottmann and Randrup 1998); Gauss-Newton on
//          distances (Lukacs, Martin and Marshall 1998).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "solid/carrier/carrier.h"

namespace swept::step {

struct Samples {
  std::vector<Eigen::Vector3d> points;
  std::vector<Eigen::Vector3d> normals;
};

struct PointSpread {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  double size = 0;  ///< mm, root mean square distance from the mean
};
PointSpread spreadOf(const Samples& samples);

/// The line that comes nearest to meeting all normals. With each normal as a line in Pluecker
/// coordinates, it is the eigenvector with the smallest eigenvalue of the sum of outer products. It
/// is not normalised; if `direction` is much shorter than 1, there is no such axis.
struct NormalsAxis {
  Eigen::Vector3d direction, moment;  ///< the moment about the mean, in units of the spread
  Eigen::Vector3d point;              ///< point of the line nearest to the mean
  double smallest = 0, second = 0;    ///< the two smallest eigenvalues
};
NormalsAxis axisOfNormals(const Samples& samples, const PointSpread& spread);

/// Sets `reversed` from the normals of the samples; for a plane, the sign of its axis.
void orient(const Samples& samples, Carrier& surface);

/// Returns a first guess, or nothing if the samples do not determine the surface.
std::optional<Carrier> guessSurface(CarrierKind kind, const Samples& samples);

/// Refines the surface by least squares on the distances of about `maxCount` points.
void refineSurface(const Samples& samples, Carrier& surface, std::size_t maxCount = 240);

/// Largest and median absolute distance of the points from the surface.
struct Residuals {
  double largest = 0, median = 0;
};
Residuals residuals(const Samples& samples, const Carrier& surface);

}  // namespace swept::step
