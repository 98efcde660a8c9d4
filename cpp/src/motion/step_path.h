// The motion of a body from one pose to the next, and the number of chords that approximate it. All
// code that moves a body between poses uses StepPath, so that the path is the same everywhere.
// Units: mm, rad, s. Cost: O(1) per query; the sphere and the longest edge take O(n).
// Sources: slerp, Shoemake 1985; the screw axis of a rigid motion, Chasles 1830.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <cstddef>

#include "motion/motion.h"
#include "swept/types.h"

namespace swept {

/// A sphere that contains the body.
struct Sphere {
  Eigen::Vector3d centre;
  double radius;
};

Sphere boundingSphere(const TriMesh& body);

/// Velocities of all points of a rigid body at one time: linear + angular x point (world).
struct Twist {
  Eigen::Vector3d linear;
  Eigen::Vector3d angular;
};

/// The motion between two poses, at any fraction s in [0, 1] of the step.
class StepPath {
 public:
  StepPath(const Pose& from, const Pose& to, Interpolation interpolation);

  Pose poseAt(double s) const;
  Placement at(double s) const;

  /// Angle by which the body turns during the whole step, 0 to pi.
  double angle() const { return angle_; }
  /// True if all points turn about one fixed axis and slide along it. Otherwise the origin of the
  /// body moves along a straight line, and the body turns about its origin.
  bool isScrew() const { return screw_; }
  /// Displacement along the axis of a screw, in mm.
  double pitch() const { return pitch_; }
  /// Axis of rotation, in world coordinates.
  Eigen::Vector3d axis() const { return from_.rotation * axis_; }
  /// A point on the axis of a screw, in world coordinates.
  Eigen::Vector3d axisPoint() const { return from_.rotation * axisPoint_ + from_.translation; }
  /// Distance (mm) of a point in body coordinates from the axis of rotation.
  double radius(const Eigen::Vector3d& point) const;
  /// Upper bound of radius() for all points of the sphere.
  double radius(const Sphere& body) const;
  /// Returns the velocities per unit of s at the time when the body is at `pose`, which must be a
  /// result of poseAt().
  Twist twistAt(const Pose& pose) const;
  /// Speed along the axis of a screw, otherwise speed of the body's origin, in mm per unit of s.
  double drift() const { return screw_ ? std::abs(pitch_) : shift().norm(); }
  /// Upper bound, in mm per unit of s, of the speed of all points within `radius` of the axis.
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
  // In the frame of the first pose.
  Eigen::Vector3d axis_ = Eigen::Vector3d::UnitX(), axisPoint_ = Eigen::Vector3d::Zero();
};

double longestEdge(const TriMesh& body);

/// An edge of length `edge` sweeps a warped patch while it turns by `turn` (rad). Returns an upper
/// bound of the distance of this patch from the two triangles that replace it. Bounds on the chords
/// of points do not include this distance.
inline double warpOf(double turn, double edge) { return edge * turn / 4; }

/// Returns how far (mm) the points of the box deviate from their chords during a step. A point
/// moves on an arc of nearly constant curvature, so it is farthest from its chord in the middle of
/// the step. The result includes 2 % for terms of fourth order.
double arcOf(const Motion& motion, std::size_t step, const Eigen::AlignedBox3d& box);

/// Returns the number of chords per step, not rounded, for which the chords of points and the side
/// patches together deviate from the true motion by at most `chord`. With n chords, a point at
/// radius r deviates by at most r a^2 / (8 n^2), where a is the angle of the step. The patches
/// deviate by warpOf(a, longest) / n.
double piecesOf(double radius, double angle, double longest, double chord);

}  // namespace swept
