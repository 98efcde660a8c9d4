// Quadratic error function of a component: E(x) = sum (n_i . (x - p_i))^2, minimised inside the
// cell.
//
// In: planes (position, normal). Out: minimiser. Units: the cell's own coordinates. Cost: O(1) per
// plane and solution.
// Source: Garland and Heckbert 1997 (quadrics); Ju et al. 2002 and Kobbelt et al. 2001 (vertex
// placement).
//
// The system is solved relative to the mass point m, the mean of the crossings: (A + mu I)(x - m) =
// b - A m. The damping mu is far smaller than the eigenvalues that a real crease contributes. In
// directions that the planes do not determine, mu keeps x at the mass point. The papers truncate
// small eigenvalues instead. Damping has no threshold at which the vertex jumps, and a solution by
// cofactors is some twenty times faster than an eigen-decomposition. A minimiser outside the cell
// is replaced by the best point of the cell's faces, edges and corners.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

#include "geometry/quadric.h"

namespace swept {

/// Sharpness (see Qef::sharpness()) of two planes that differ by 20 degrees.
constexpr double kMinSharpness = 0.03;

/// Accumulates planes in the coordinates of the cell, [0, 1]^3.
class Qef {
 public:
  void add(const Eigen::Vector3d& point, const Eigen::Vector3d& normal) {
    planes_.addPlane(normal, point, 1);
    mass_ += point;
    count_ += 1;
  }
  int count() const { return count_; }
  Eigen::Vector3d massPoint() const { return mass_ / count_; }
  Eigen::Matrix3d matrix() const { return planes_.matrix(); }
  /// Second invariant of the mean normal tensor: 0 for one plane, sin^2(t/2) cos^2(t/2) for two
  /// planes that differ by the angle t, 1/3 for the corner of a cube.
  double sharpness() const {
    const auto& [xx, xy, xz, yy, yz, zz] = planes_.a;
    const double minors = xx * yy - xy * xy + yy * zz - yz * yz + zz * xx - xz * xz;
    return minors / (static_cast<double>(count_) * count_);
  }
  double error(const Eigen::Vector3d& x) const { return planes_.error(x); }

  /// Returns the minimiser in the box [margin, 1 - margin]^3. `free` receives the unbounded
  /// minimiser.
  Eigen::Vector3d solve(double margin, Eigen::Vector3d& free) const {
    return solve(margin, kDamping, free);
  }
  /// Does the same with another damping, given as a fraction of the number of planes.
  Eigen::Vector3d solve(double margin, double damping, Eigen::Vector3d& free) const;

  static constexpr double kDamping = 1e-5;  ///< as strong as a crease of 0.4 degrees

 private:
  Eigen::Vector3d solveInBox(const Eigen::Matrix3d& a, const Eigen::Vector3d& g, double low,
                             double high, const Eigen::Vector3d& unbounded) const;

  Quadric planes_;
  Eigen::Vector3d mass_ = Eigen::Vector3d::Zero();
  int count_ = 0;
};

}  // namespace swept
