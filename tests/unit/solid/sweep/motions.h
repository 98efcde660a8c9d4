// Motions and bodies for the tests of swept surfaces. The truth about a motion comes from Eigen's
// own slerp and from a screw made of rotations about a known axis, not from StepPath.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <functional>

#include "motion/step_path.h"
#include "solid/carrier/carrier.h"
#include "solid/carrier/curve.h"

namespace swept::step {

using Eigen::Vector3d;

constexpr Range kWhole{0, 1};  // fractions of a whole motion

inline Pose pose(const Vector3d& translation, const Vector3d& axis = {0, 0, 1}, double angle = 0) {
  Pose result;
  result.translation = translation;
  result.rotation = Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis.normalized()));
  return result;
}

/// A motion with an independent function for the position of a point of the body at s.
struct TestMotion {
  Pose from, to;
  Interpolation interpolation = Interpolation::Linear;
  StepPath path() const { return {from, to, interpolation}; }
  Vector3d at(const Vector3d& x, double s) const {
    if (interpolation == Interpolation::Linear) {
      return from.rotation.slerp(s, to.rotation) * x + (1 - s) * from.translation +
             s * to.translation;
    }
    return screw(s) * x;
  }
  /// Returns the velocity per unit of s, by finite differences.
  Vector3d velocity(const Vector3d& x, double s) const {
    constexpr double h = 1e-5;
    return (8 * (at(x, s + h) - at(x, s - h)) - (at(x, s + 2 * h) - at(x, s - 2 * h))) / (12 * h);
  }
  Vector3d turned(const Vector3d& direction, double s) const {
    return at(direction, s) - at(Vector3d::Zero(), s);
  }
  // For screws only: axis, turn (rad) and slide (mm) of the whole step.
  Vector3d axisPoint = Vector3d::Zero(), axis = Vector3d::UnitZ();
  double turn = 0, slide = 0;

 private:
  Eigen::Isometry3d screw(double s) const {
    return Eigen::Translation3d(axisPoint + s * slide * axis) * Eigen::AngleAxisd(s * turn, axis) *
           Eigen::Translation3d(-axisPoint);
  }
};

/// Returns a general motion: a turn of `angle` about a skew axis while the origin moves.
inline TestMotion generalMotion(double angle = 0.7) {
  TestMotion motion;
  motion.from = pose({3, -2, 5}, {1, 0, 2}, 0.4);
  motion.to.translation = Vector3d(40, 10, 25);
  motion.to.rotation =
      Eigen::AngleAxisd(angle, Vector3d(1, 2, 3).normalized()) * motion.from.rotation;
  return motion;
}

inline TestMotion lineMotion(const Vector3d& travel) {
  TestMotion motion;
  motion.from = pose({0, 0, 0});
  motion.to = pose(travel);
  return motion;
}

/// Returns a screw about an axis, from the unmoved body.
inline TestMotion screwMotion(const Vector3d& point, const Vector3d& axis, double turn,
                              double slide) {
  TestMotion motion;
  motion.interpolation = Interpolation::Screw;
  motion.axisPoint = point;
  motion.axis = axis.normalized();
  motion.turn = turn;
  motion.slide = slide;
  motion.from = pose({0, 0, 0});
  motion.to = pose(motion.at(Vector3d::Zero(), 1), axis, turn);
  return motion;
}

inline Curve circleCurve(const Vector3d& centre, const Vector3d& axis, double radius,
                         double last = 2 * M_PI) {
  Curve curve;
  curve.kind = CurveKind::Circle;
  curve.start = centre;
  curve.axis = axis.normalized();
  curve.xdir = anyOrthogonal(curve.axis);
  curve.radius = radius;
  curve.last = last;
  return curve;
}

inline Carrier carrierOf(CarrierKind kind, const Vector3d& point, const Vector3d& axis,
                         double radius = 0, double minor = 0) {
  Carrier carrier;
  carrier.kind = kind;
  carrier.point = point;
  carrier.axis = axis.normalized();
  carrier.radius = radius;
  carrier.minor = minor;
  return carrier;
}

}  // namespace swept::step
