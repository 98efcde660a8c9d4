// Sheet: a free-form surface S(u, t), a tensor product of B-splines, with partial derivatives S_u
// and S_t. It carries faces that lie on no plane, cylinder or other simple surface: surfaces that
// an edge sweeps, and surfaces in which a face grazes the envelope (solid/sweep/swept_surface.h).
// Units:   mm. Distances are exact. The surface is continued a little beyond its borders, so that
// borders of faces do not lie at its end.
// Cost:    O(samples) for a distance, O(1) if the parameters of a nearby point are known.
// Source:  foot points by Newton's method with a damped step (Piegl and Tiller, section 6.1).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "solid/carrier/bspline.h"

namespace swept::step {

class Sheet {
 public:
  /// The nearest point of the surface, with the derivatives there. `isInside`: false if this point
  /// lies at the end of the continuation. The line from the given point to it then need not be
  /// perpendicular to the surface.
  struct Foot {
    double u = 0, t = 0;
    Eigen::Vector3d at, alongU, alongT;
    bool isInside = true;
    Eigen::Vector3d normal() const { return alongU.cross(alongT).normalized(); }
  };

  /// `poles`: row after row; the index along u changes slowest.
  Sheet(Knots u, Knots t, std::vector<Eigen::Vector3d> poles);

  Eigen::Vector3d at(double u, double t) const;
  Foot footAt(double u, double t) const;
  /// Returns the foot point nearest to p. Newton's method starts at the nearest sample.
  Foot foot(const Eigen::Vector3d& p) const;
  /// Does the same, but starts at the given parameters, such as those found for a nearby point.
  Foot foot(const Eigen::Vector3d& p, double u, double t) const;
  /// Positive on the side of S_u x S_t.
  double distance(const Eigen::Vector3d& p) const;
  /// Unit vector along S_u x S_t at the foot point.
  Eigen::Vector3d normal(const Eigen::Vector3d& p) const { return foot(p).normal(); }

  const Knots& knotsU() const { return u_; }
  const Knots& knotsT() const { return t_; }
  const std::vector<Eigen::Vector3d>& poles() const { return poles_; }
  const Eigen::Vector3d& pole(std::size_t i, std::size_t j) const {
    return poles_[i * t_.poleCount() + j];
  }
  /// Returns the part of the surface between these parameters.
  Sheet part(Range u, Range t) const;

 private:
  struct Jet {
    Eigen::Vector3d at, u, t, uu, ut, tt;
  };
  Jet jet(double u, double t) const;

  Knots u_, t_;
  std::vector<Eigen::Vector3d> poles_;
  Range extendedU_, extendedT_;  // ranges of the parameters, including the continuation
  std::vector<double> sampleU_, sampleT_;
  std::vector<Eigen::Vector3d> samples_;
  double spacing_ = 0;  // mm, approximate distance between samples
};

}  // namespace swept::step
