// Carrier: the unbounded surface on which a face lies. Carriers are elementary surfaces,
// extrusions and revolutions. They have a signed distance and an outward normal.
// Units:   mm, rad. The distance is exact (not algebraic) and positive on the side of `normal`.
// Cost:    O(1) per query.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <memory>

#include "solid/carrier/profile.h"

namespace swept::step {

enum class CarrierKind { Facet, Plane, Cylinder, Cone, Sphere, Torus, Extrusion, Revolution };
const char* surfaceKindName(CarrierKind kind);
/// The name of faces on free-form surfaces (sheet.h), which are no carriers.
constexpr const char* kSheetName = "sheet";

struct Carrier {
  CarrierKind kind = CarrierKind::Facet;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< a point on the plane or axis, or the centre
  /// Unit vector: normal of the plane, or direction of the axis.
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  /// Direction of angle 0. If this is the zero vector, anyOrthogonal(axis) replaces it.
  Eigen::Vector3d xdir = Eigen::Vector3d::Zero();
  /// cylinder or sphere; cone: radius at `point`; torus: radius of its centre circle
  double radius = 0;
  double minor = 0;    ///< torus: radius of the tube
  double tubeMid = 0;  ///< torus: tube angle in the middle of the face
  /// cone: angle between axis and generatrix; the radius grows along the axis
  double halfAngle = 0;
  double cosine = 1, sine = 0;  ///< cosine and sine of halfAngle
  /// True if the material lies outside (a bore). The outward normal then points towards the axis or
  /// centre.
  bool reversed = false;
  /// The curve that generates the surface; outward is to the right of it. The profile of an
  /// extrusion lies in the plane through `point` perpendicular to the axis. Its coordinates are
  /// along xdir and axis x xdir. The profile of a revolution lies in the half plane of xdir. Its
  /// coordinates are the distance from the axis and the position along the axis.
  std::shared_ptr<const Profile> profile;

  bool isPlanar() const { return kind == CarrierKind::Facet || kind == CarrierKind::Plane; }
  bool hasProfile() const { return profile != nullptr; }
  void setHalfAngle(double angle);
  /// Returns the coordinates of a point in the plane of the profile. For a revolution, the point is
  /// first turned about the axis into the half plane of xdir.
  Eigen::Vector2d inProfile(const Eigen::Vector3d& p) const;
  double distance(const Eigen::Vector3d& p) const;
  /// Returns the unit normal that points away from the material.
  Eigen::Vector3d normal(const Eigen::Vector3d& p) const;
};

/// Returns a unit vector orthogonal to the unit vector `axis`. Equal arguments give equal results.
Eigen::Vector3d anyOrthogonal(const Eigen::Vector3d& axis);

}  // namespace swept::step
