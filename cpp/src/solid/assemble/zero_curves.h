// Zeros of functions of one and of two parameters.
// Cost:    for one parameter, 256 evaluations, and about ten for each zero. For two parameters,
//          8,000 evaluations, and some hundred for each curve.
// Source:  I. Oliveira and R. Takahashi, "An enhancement of the bisection method average
//          performance preserving minmax optimality", ACM TOMS 47 (2020).
// Limits:  zeros nearer to each other than the steps may be missed.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "solid/carrier/bspline.h"

namespace swept::step {

constexpr int kZeroSteps = 256;

using OfOne = std::function<double(double)>;

/// Returns the zero between two points. f is negative at one of them, and not at the other.
double zeroBetween(const OfOne& f, double a, double b);

/// Returns the zeros of a continuous function in the range, in order.
std::vector<double> zerosOf(const OfOne& f, Range range);

using OfTwo = std::function<double(const Eigen::Vector2d&)>;

/// A part of a curve on which a function of two parameters is zero. Its own parameter is the
/// position along a straight line in the plane of the parameters, so the curve is a smooth function
/// of it.
class ZeroArc {
 public:
  /// `points`: zeros in order, multiplied by the scale. They advance along `direction`, which is a
  /// unit vector.
  ZeroArc(OfTwo f, Eigen::Vector2d scale, Eigen::Vector2d direction,
          std::vector<Eigen::Vector2d> points);
  /// mm
  Range range() const;
  /// Returns the parameters of the function.
  Eigen::Vector2d at(double t) const;

 private:
  OfTwo f_;
  Eigen::Vector2d scale_, direction_;
  std::vector<Eigen::Vector2d> points_;
};

/// Returns the curves on which f is zero in a rectangle. `scale`: mm per unit of each parameter.
std::vector<ZeroArc> zeroArcs(const OfTwo& f, Range x, Range y, const Eigen::Vector2d& scale);

}  // namespace swept::step
