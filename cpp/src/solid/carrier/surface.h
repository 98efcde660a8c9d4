// Elementary surfaces, and profiles pushed or turned: signed distance, outward normal, projection.
// Units: mm, rad. The distance is exact (not algebraic) and positive on the side of `normal`.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <memory>

#include "solid/carrier/profile.h"

namespace swept::step {

enum class SurfaceKind { Facet, Plane, Cylinder, Cone, Sphere, Torus, Extrusion, Revolution };
const char* surfaceKindName(SurfaceKind kind);

struct Surface {
  SurfaceKind kind = SurfaceKind::Facet;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< on the plane, on the axis, or the centre
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< plane normal or axis, unit
  Eigen::Vector3d xdir =
      Eigen::Vector3d::Zero();  ///< where angles start; zero: anyOrthogonal(axis)
  double radius = 0;            ///< cylinder, sphere; cone: at `point`; torus: of the centre circle
  double minor = 0;             ///< torus: of the tube
  double tubeMid = 0;           ///< torus: tube angle in the middle of the face
  double halfAngle = 0;  ///< cone: between axis and generator line; radius grows along the axis
  double cosine = 1, sine = 0;  ///< of halfAngle
  bool reversed = false;  ///< material lies outside (a bore): outward is towards the axis or centre
  /// Extrusion: in the plane across the axis, by xdir and axis x xdir from `point`. Revolution: in
  /// the half plane of xdir, by distance from the axis and along it. Outward is to its right.
  std::shared_ptr<const Profile> profile;

  bool isPlanar() const { return kind == SurfaceKind::Facet || kind == SurfaceKind::Plane; }
  bool hasProfile() const { return profile != nullptr; }
  void setHalfAngle(double angle);
  /// Where a point lies in the plane of the profile.
  Eigen::Vector2d inProfile(const Eigen::Vector3d& p) const;
  double distance(const Eigen::Vector3d& p) const;
  /// Unit, away from the material.
  Eigen::Vector3d normal(const Eigen::Vector3d& p) const;
};

/// Any unit vector orthogonal to the unit vector `axis`; the same for the same axis.
Eigen::Vector3d anyOrthogonal(const Eigen::Vector3d& axis);

}  // namespace swept::step
