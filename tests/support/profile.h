// Plane outlines of straight lines and arcs, and the prisms extruded from them.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "support/truth.h"

namespace swept::test {

/// One piece of an outline. The material lies on its left.
struct ProfilePiece {
  Eigen::Vector2d from, to;
  bool arc = false;
  Eigen::Vector2d centre{0, 0};
  double radius = 0, startAngle = 0, sweepAngle = 0;  ///< rad, counter-clockwise positive
};

class Profile {
 public:
  void polygon(const std::vector<Eigen::Vector2d>& corners);
  void line(const Eigen::Vector2d& from, const Eigen::Vector2d& to);
  void arc(const Eigen::Vector2d& centre, double radius, double startAngle, double sweepAngle);

  double area() const;
  double length() const;
  /// Returns the distance of a point from the outline, negative inside.
  double signedDistance(const Eigen::Vector2d& p) const;
  /// Returns points along the outline, `spacing` apart or closer.
  std::vector<Eigen::Vector2d> points(double spacing) const;
  /// Returns the corners at which the direction changes by more than 10 degrees.
  std::vector<Eigen::Vector2d> corners() const;

  /// Sets distance, surface, creases, volume and area of `truth` to those of the prism from z0 to
  /// z1.
  void extrude(double z0, double z1, double spacing, Truth& truth) const;

 private:
  std::vector<ProfilePiece> pieces_;
};

}  // namespace swept::test
