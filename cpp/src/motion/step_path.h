// The motion of a body from one pose to the next, and in how many pieces it is followed. All parts
// that move a body between poses ask this class, so that none takes another path than the rest.
// Units: mm, rad, s. Cost: O(1) a query; the sphere and the longest edge take O(n).
// Sources: slerp, Shoemake 1985; the screw axis of a rigid motion, Chasles 1830.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>

#include "motion/motion.h"
#include "swept/types.h"

namespace swept {

/// Holds the body.
struct Sphere {
  Eigen::Vector3d centre;
  double radius;
};

Sphere boundingSphere(const TriMesh& body);

/// Velocities of all points of a rigid body at one moment: linear + angular x point (world).
struct Twist {
  Eigen::Vector3d linear;
  Eigen::Vector3d angular;
};

/// At any fraction s in [0, 1] of the step.
class StepPath {
 public:
  StepPath(const Pose& from, const Pose& to, Interpolation interpolation);

  Pose poseAt(double s) const;
  Placement at(double s) const;

  /// Of the whole step, 0 to pi.
  double angle() const { return angle_; }
  /// True if all points turn about one fixed axis and slide along it; else the body's origin moves
  /// along a straight line and the body turns about it.
  bool isScrew() const { return screw_; }
  /// mm, along the axis of a screw.
  double pitch() const { return pitch_; }
  /// World frame.
  Eigen::Vector3d axis() const { return from_.rotation * axis_; }
  /// World frame: a point of the axis of a screw.
  Eigen::Vector3d axisPoint() const { return from_.rotation * axisPoint_ + from_.translation; }
  /// How far a point of the body (body frame) lies from the line that it turns about.
  double radius(const Eigen::Vector3d& point) const;
  /// At least the largest radius of the sphere's points.
  double radius(const Sphere& body) const;
  /// Per unit of s, at the moment at which the body is placed by `pose`, one of poseAt().
  Twist twistAt(const Pose& pose) const;
  /// Speed along the line, in mm per unit of s: the pitch of a screw, else the speed of the shift.
  double drift() const { return screw_ ? std::abs(pitch_) : shift().norm(); }
  /// mm per unit of s, no point at most `radius` from the line is faster anywhere in the step.
  double fastest(double radius) const {
    return screw_ ? std::hypot(pitch_, angle_ * radius) : shift().norm() + angle_ * radius;
  }

 private:
  Eigen::Vector3d shift() const { return toTranslation_ - from_.translation; }

  Pose from_;
  Eigen::Vector3d toTranslation_;
  double toTime_;
  bool screw_ = false;
  double angle_ = 0, pitch_ = 0;
  // Frame of the first pose.
  Eigen::Vector3d axis_ = Eigen::Vector3d::UnitX(), axisPoint_ = Eigen::Vector3d::Zero();
};

double longestEdge(const TriMesh& body);

/// The patch of an edge over a turn (rad) is warped: its two triangles leave the ruled surface by
/// up to this, which bounds on the chords of points do not see.
inline double warpOf(double turn, double edge) { return edge * turn / 4; }

/// Pieces that a step is cut into, so that the chords of points and the side patches together leave
/// the true motion by at most `chord`; not rounded. With n pieces the arc is off by r a^2 / (8 n^2)
/// (the exact sagitta is a little less) and the patch by warpOf(a, longest) / n.
double piecesOf(double radius, double angle, double longest, double chord);

}  // namespace swept
