// A cylinder or a torus as a pipe: circles of one radius around a centre line, which is the axis of
// a cylinder and the circle around which the tube of a torus lies. A sphere is a torus whose centre
// line is a point.
// Units:   mm. x is the position on the centre line: mm on a cylinder, rad on a torus.
// Method:  A point of a circle with the unit normal n has the same speed along n as the centre of
//          the circle, as the body cannot change the distance between them. So it touches the
//          envelope if n is orthogonal to the velocity v of the centre. With n = cos(psi) first +
//          sin(psi) second, this is cos(psi) v.first + sin(psi) v.second = 0.
// Source:  Adsul, Machchhar and Sohoni, CAGD 31 (2014), for points of contact.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

#include "solid/assemble/body_geometry.h"
#include "solid/sweep/contact.h"

namespace swept::step {

class Pipe {
 public:
  /// `surface`: a cylinder, a torus or a sphere.
  explicit Pipe(const BodySurface& surface);

  bool isCylinder() const { return isCylinder_; }
  bool isSphere() const { return !isCylinder_ && ring_ == 0; }
  double radius() const { return radius_; }
  /// mm per unit of x, on the outside of the pipe
  double scale() const { return isCylinder_ ? 1 : ring_ + radius_; }
  /// Returns the point of the circle at x in a direction: (cos(psi), sin(psi)).
  Eigen::Vector3d at(double x, const Eigen::Vector2d& direction) const;
  /// Returns x and psi of a point. If x is an angle, it is within pi of `near`.
  Eigen::Vector2d parametersOf(const Eigen::Vector3d& p, double near) const;
  /// Returns (v.first, v.second) of the circle at x.
  Eigen::Vector2d speeds(double x, const Moment& moment) const;
  /// Returns the derivative of speeds() with respect to x.
  Eigen::Vector2d speedChanges(double x, const Moment& moment) const;

 private:
  Eigen::Vector3d awayAt(double x) const { return std::cos(x) * x_ + std::sin(x) * y_; }

  bool isCylinder_;
  Eigen::Vector3d origin_, x_, y_, axis_;
  double ring_, radius_;  // of the centre line, if it is a circle; of the pipe
};

}  // namespace swept::step
