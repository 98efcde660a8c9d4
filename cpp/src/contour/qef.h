// Quadratic error function of a component: E(x) = sum (n_i . (x - p_i))^2, minimised inside the
// cell.
//
// In: planes (position, normal). Out: minimiser. Units: the cell's own coordinates. Cost: O(1) per
// plane and solution.
// Source: Garland and Heckbert 1997 (quadrics); Ju et al. 2002 and Kobbelt et al. 2001 (vertex
// placement); METHOD.md section 4.
//
// Solved about the mass point m as (A + mu I)(x - m) = b - A m, with a damping mu far below what a
// real crease contributes; directions about which the planes say nothing keep the mass point. The
// papers truncate small eigenvalues instead. Damping has no threshold at which the vertex jumps,
// and solving by cofactors is some twenty times faster than an eigen-decomposition. A minimiser
// outside the cell is replaced by the best point of the cell's faces, edges and corners.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

namespace swept {

/// Sharpness (see below) of two planes that differ by 20 degrees.
constexpr double kMinSharpness = 0.03;

/// Accumulates planes in the coordinates of the cell, [0, 1]^3.
class Qef {
 public:
  void add(const Eigen::Vector3d& point, const Eigen::Vector3d& normal) {
    const double d = normal.dot(point);
    xx_ += normal[0] * normal[0];
    xy_ += normal[0] * normal[1];
    xz_ += normal[0] * normal[2];
    yy_ += normal[1] * normal[1];
    yz_ += normal[1] * normal[2];
    zz_ += normal[2] * normal[2];
    b_ += d * normal;
    c_ += d * d;
    mass_ += point;
    count_ += 1;
  }
  int count() const { return count_; }
  Eigen::Vector3d massPoint() const { return mass_ / count_; }
  Eigen::Matrix3d matrix() const;
  /// Second invariant of the mean normal tensor: 0 for one plane, sin^2(t/2) cos^2(t/2) for two
  /// planes that differ by the angle t, 1/3 for the corner of a cube.
  double sharpness() const {
    const double minors = xx_ * yy_ - xy_ * xy_ + yy_ * zz_ - yz_ * yz_ + zz_ * xx_ - xz_ * xz_;
    return minors / (static_cast<double>(count_) * count_);
  }
  double error(const Eigen::Vector3d& x) const;

  /// Minimiser in the box [margin, 1 - margin]^3. `free` receives the minimiser without the box.
  Eigen::Vector3d solve(double margin, Eigen::Vector3d& free) const {
    return solve(margin, kDamping, free);
  }
  /// `damping` is a fraction of the number of planes.
  Eigen::Vector3d solve(double margin, double damping, Eigen::Vector3d& free) const;

  static constexpr double kDamping = 1e-5;  ///< as strong as a crease of 0.4 degrees

 private:
  Eigen::Vector3d solveInBox(const Eigen::Matrix3d& a, const Eigen::Vector3d& g, double low,
                             double high, const Eigen::Vector3d& unbounded) const;

  double xx_ = 0, xy_ = 0, xz_ = 0, yy_ = 0, yz_ = 0, zz_ = 0, c_ = 0;
  Eigen::Vector3d b_ = Eigen::Vector3d::Zero(), mass_ = Eigen::Vector3d::Zero();
  int count_ = 0;
};

}  // namespace swept
