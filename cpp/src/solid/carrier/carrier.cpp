// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/carrier/carrier.h"

#include <array>
#include <cmath>

namespace swept::step {

const char* surfaceKindName(CarrierKind kind) {
  constexpr std::array<const char*, 8> kNames{"facet",  "plane", "cylinder",  "cone",
                                              "sphere", "torus", "extrusion", "revolution"};
  return kNames[static_cast<std::size_t>(kind)];
}

Eigen::Vector3d anyOrthogonal(const Eigen::Vector3d& axis) {
  int smallest = 0;
  axis.cwiseAbs().minCoeff(&smallest);
  return axis.cross(Eigen::Vector3d::Unit(smallest)).normalized();
}

void Carrier::setHalfAngle(double angle) {
  halfAngle = angle;
  cosine = std::cos(angle);
  sine = std::sin(angle);
}

Eigen::Vector2d Carrier::inProfile(const Eigen::Vector3d& p) const {
  const Eigen::Vector3d d = p - point;
  if (kind == CarrierKind::Extrusion) return {d.dot(xdir), d.dot(axis.cross(xdir))};
  const double along = d.dot(axis);
  return {(d - along * axis).norm(), along};
}

double Carrier::distance(const Eigen::Vector3d& p) const {
  const Eigen::Vector3d d = p - point;
  const double along = d.dot(axis);
  double value = 0;
  switch (kind) {
    case CarrierKind::Facet:
    case CarrierKind::Plane:
      return along;
    case CarrierKind::Sphere:
      value = d.norm() - radius;
      break;
    case CarrierKind::Cylinder:
      value = (d - along * axis).norm() - radius;
      break;
    case CarrierKind::Cone:
      value = ((d - along * axis).norm() - radius) * cosine - along * sine;
      break;
    case CarrierKind::Torus: {
      const double out = (d - along * axis).norm() - radius;
      value = std::sqrt(out * out + along * along) - minor;
    } break;
    case CarrierKind::Extrusion:
    case CarrierKind::Revolution:
      value = profile->distance(inProfile(p));
      break;
  }
  return reversed ? -value : value;
}

Eigen::Vector3d Carrier::normal(const Eigen::Vector3d& p) const {
  if (isPlanar()) return axis;
  const Eigen::Vector3d d = p - point;
  const double along = d.dot(axis);
  Eigen::Vector3d radial = d - along * axis;
  const double rho = radial.norm();
  radial = rho > 1e-12 ? Eigen::Vector3d(radial / rho) : anyOrthogonal(axis);
  Eigen::Vector3d result = radial;
  if (kind == CarrierKind::Sphere) {
    result = d.norm() > 1e-12 ? Eigen::Vector3d(d.normalized()) : axis;
  } else if (kind == CarrierKind::Cone) {
    result = cosine * radial - sine * axis;
  } else if (kind == CarrierKind::Torus) {
    const Eigen::Vector3d tube = (rho - radius) * radial + along * axis;
    result = tube.norm() > 1e-12 ? Eigen::Vector3d(tube.normalized()) : radial;
  } else if (hasProfile()) {
    const Eigen::Vector2d n = profile->normal(inProfile(p));
    result = kind == CarrierKind::Extrusion ? n.x() * xdir + n.y() * axis.cross(xdir)
                                            : n.x() * radial + n.y() * axis;
  }
  return reversed ? Eigen::Vector3d(-result) : result;
}

}  // namespace swept::step
