// Carrier surfaces of faces: elementary surfaces, extrusions and revolutions, with signed distance,
// outward normal and projection.
// Units: mm, rad. The distance is exact (not algebraic) and positive on the side of `normal`. Cost:
// O(1) per query.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <memory>

#include "solid/carrier/profile.h"

namespace swept::step {

enum class CarrierKind { Facet, Plane, Cylinder, Cone, Sphere, Torus, Extrusion, Revolution };
const char* surfaceKindName(CarrierKind kind);

struct Carrier {
  CarrierKind kind = CarrierKind::Facet;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< a point on the plane or axis, or the centre
  /// Normal of the plane, or direction of the axis; unit.
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  Eigen::Vector3d xdir =
      Eigen::Vector3d::Zero();  ///< where angles start; zero: anyOrthogonal(axis)
  double radius = 0;            ///< cylinder, sphere; cone: at `point`; torus: of the centre circle
  double minor = 0;             ///< torus: radius of the tube
  double tubeMid = 0;           ///< torus: tube angle in the middle of the face
  double halfAngle = 0;  ///< cone: between axis and generator line; the radius grows along the axis
  double cosine = 1, sine = 0;  ///< of halfAngle
  /// The material lies outside (a bore): outward points towards the axis or centre.
  bool reversed = false;
  /// Extrusion: a curve in the plane across the axis; coordinates along xdir and axis x xdir, from
  /// `point`. Revolution: a curve in the half plane of xdir; coordinates are the distance from the
  /// axis and the position along it. Outward is to the right of the curve.
  std::shared_ptr<const Profile> profile;

  bool isPlanar() const { return kind == CarrierKind::Facet || kind == CarrierKind::Plane; }
  bool hasProfile() const { return profile != nullptr; }
  void setHalfAngle(double angle);
  /// The coordinates of a point in the plane of the profile.
  Eigen::Vector2d inProfile(const Eigen::Vector3d& p) const;
  double distance(const Eigen::Vector3d& p) const;
  /// Unit, away from the material.
  Eigen::Vector3d normal(const Eigen::Vector3d& p) const;
};

/// Some unit vector orthogonal to the unit vector `axis`; always the same one for the same axis.
Eigen::Vector3d anyOrthogonal(const Eigen::Vector3d& axis);

}  // namespace swept::step
