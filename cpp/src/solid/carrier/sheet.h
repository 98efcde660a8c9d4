// Sheet: a free-form surface S(u, t), a tensor product of B-splines. It carries faces that lie on
// no plane, cylinder or other simple surface: surfaces that an edge sweeps, and surfaces in which a
// face grazes the envelope. Units:   mm. Cost:    O(degree^2) per point, O(poles) for a part.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "solid/carrier/bspline.h"

namespace swept::step {

class Sheet {
 public:
  /// `poles`: row after row; the index along u changes slowest.
  Sheet(Knots u, Knots t, std::vector<Eigen::Vector3d> poles)
      : u_(std::move(u)), t_(std::move(t)), poles_(std::move(poles)) {}

  Eigen::Vector3d at(double u, double t) const;

  const Knots& knotsU() const { return u_; }
  const Knots& knotsT() const { return t_; }
  const std::vector<Eigen::Vector3d>& poles() const { return poles_; }
  const Eigen::Vector3d& pole(std::size_t i, std::size_t j) const {
    return poles_[i * t_.poleCount() + j];
  }
  /// Returns the part of the surface between these parameters.
  Sheet part(Range u, Range t) const;

 private:
  Knots u_, t_;
  std::vector<Eigen::Vector3d> poles_;
};

}  // namespace swept::step
