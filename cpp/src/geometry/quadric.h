// Weighted quadratic error of planes: E(x) = sum w (n . (x - p))^2 (Garland and Heckbert 1997).
//
// Units: those of the points. Points should be relative to a nearby origin, because a distant
// origin increases the rounding errors.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <array>

namespace swept {

struct Quadric {
  std::array<double, 6> a{};  ///< xx xy xz yy yz zz
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  double c = 0;
  double weight = 0;

  void addPlane(const Eigen::Vector3d& normal, const Eigen::Vector3d& point, double w) {
    const double d = normal.dot(point);
    a[0] += w * normal[0] * normal[0];
    a[1] += w * normal[0] * normal[1];
    a[2] += w * normal[0] * normal[2];
    a[3] += w * normal[1] * normal[1];
    a[4] += w * normal[1] * normal[2];
    a[5] += w * normal[2] * normal[2];
    b += w * d * normal;
    c += w * d * d;
    weight += w;
  }
  Quadric& operator+=(const Quadric& o) {
    for (int i = 0; i < 6; ++i) a[i] += o.a[i];
    b += o.b;
    c += o.c;
    weight += o.weight;
    return *this;
  }
  Quadric& operator-=(const Quadric& o) {
    for (int i = 0; i < 6; ++i) a[i] -= o.a[i];
    b -= o.b;
    c -= o.c;
    weight -= o.weight;
    return *this;
  }
  Eigen::Matrix3d matrix() const {
    Eigen::Matrix3d m;
    m << a[0], a[1], a[2], a[1], a[3], a[4], a[2], a[4], a[5];
    return m;
  }
  double error(const Eigen::Vector3d& x) const {
    const double e = x.dot(matrix() * x) - 2 * x.dot(b) + c;
    return e > 0 ? e : 0;
  }
  /// Returns the mean squared distance of x from the planes.
  double mean(const Eigen::Vector3d& x) const { return weight > 0 ? error(x) / weight : 0; }
  /// Returns the minimiser of error() plus a small damping term, which pulls it towards `about`. In
  /// directions that the planes do not determine, the result stays at `about`. About ten times as
  /// fast as minimise().
  Eigen::Vector3d dampedMinimiser(const Eigen::Vector3d& about) const {
    // With this damping, planes at an angle below about 0.1 degrees act as one plane.
    constexpr double kDamping = 1e-6;
    Eigen::Matrix3d m = matrix();
    const Eigen::Vector3d g = b - m * about;
    m.diagonal().array() += kDamping * (a[0] + a[3] + a[5]);
    return about + m.ldlt().solve(g);
  }
  /// Returns the minimiser nearest to `about`. Ignores eigenvalues below `cut` times the largest
  /// one. `rank` receives the number of the others: 3 for a corner, 2 for an edge, 1 for a plane.
  Eigen::Vector3d minimise(const Eigen::Vector3d& about, double cut, int& rank) const {
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
    const Eigen::Matrix3d m = matrix();
    solver.computeDirect(m);
    const Eigen::Vector3d g = b - m * about;
    const double least = cut * solver.eigenvalues()[2];
    Eigen::Vector3d x = about;
    rank = 0;
    for (int i = 2; i >= 0 && solver.eigenvalues()[i] > least; --i, ++rank) {
      const Eigen::Vector3d axis = solver.eigenvectors().col(i);
      x += axis * (axis.dot(g) / solver.eigenvalues()[i]);
    }
    return x;
  }
};

}  // namespace swept
