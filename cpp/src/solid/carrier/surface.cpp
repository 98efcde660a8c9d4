// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/carrier/surface.h"

#include <cmath>

namespace swept::step {

const char* surfaceKindName(SurfaceKind kind) {
  switch (kind) {
    case SurfaceKind::Facet:
      return "facet";
    case SurfaceKind::Plane:
      return "plane";
    case SurfaceKind::Cylinder:
      return "cylinder";
    case SurfaceKind::Cone:
      return "cone";
    case SurfaceKind::Sphere:
      return "sphere";
    case SurfaceKind::Torus:
      return "torus";
    case SurfaceKind::Extrusion:
      return "extrusion";
    case SurfaceKind::Revolution:
      return "revolution";
  }
  return "?";
}

Eigen::Vector3d anyOrthogonal(const Eigen::Vector3d& axis) {
  int smallest = 0;
  axis.cwiseAbs().minCoeff(&smallest);
  return axis.cross(Eigen::Vector3d::Unit(smallest)).normalized();
}

void Surface::setHalfAngle(double angle) {
  halfAngle = angle;
  cosine = std::cos(angle);
  sine = std::sin(angle);
}

Eigen::Vector2d Surface::inProfile(const Eigen::Vector3d& p) const {
  const Eigen::Vector3d d = p - point;
  if (kind == SurfaceKind::Extrusion) return {d.dot(xdir), d.dot(axis.cross(xdir))};
  const double along = d.dot(axis);
  return {(d - along * axis).norm(), along};
}

double Surface::distance(const Eigen::Vector3d& p) const {
  const Eigen::Vector3d d = p - point;
  const double along = d.dot(axis);
  double value = 0;
  switch (kind) {
    case SurfaceKind::Facet:
    case SurfaceKind::Plane:
      return along;
    case SurfaceKind::Sphere:
      value = d.norm() - radius;
      break;
    case SurfaceKind::Cylinder:
      value = (d - along * axis).norm() - radius;
      break;
    case SurfaceKind::Cone:
      value = ((d - along * axis).norm() - radius) * cosine - along * sine;
      break;
    case SurfaceKind::Torus: {
      const double out = (d - along * axis).norm() - radius;
      value = std::sqrt(out * out + along * along) - minor;
    } break;
    case SurfaceKind::Extrusion:
    case SurfaceKind::Revolution:
      value = profile->distance(inProfile(p));
      break;
  }
  return reversed ? -value : value;
}

Eigen::Vector3d Surface::normal(const Eigen::Vector3d& p) const {
  if (isPlanar()) return axis;
  const Eigen::Vector3d d = p - point;
  const double along = d.dot(axis);
  Eigen::Vector3d radial = d - along * axis;
  const double rho = radial.norm();
  radial = rho > 1e-12 ? Eigen::Vector3d(radial / rho) : anyOrthogonal(axis);
  Eigen::Vector3d result = radial;
  if (kind == SurfaceKind::Sphere) {
    result = d.norm() > 1e-12 ? Eigen::Vector3d(d.normalized()) : axis;
  } else if (kind == SurfaceKind::Cone) {
    result = cosine * radial - sine * axis;
  } else if (kind == SurfaceKind::Torus) {
    const Eigen::Vector3d tube = (rho - radius) * radial + along * axis;
    result = tube.norm() > 1e-12 ? Eigen::Vector3d(tube.normalized()) : radial;
  } else if (hasProfile()) {
    const Eigen::Vector2d n = profile->normal(inProfile(p));
    result = kind == SurfaceKind::Extrusion ? n.x() * xdir + n.y() * axis.cross(xdir)
                                            : n.x() * radial + n.y() * axis;
  }
  return reversed ? Eigen::Vector3d(-result) : result;
}

}  // namespace swept::step
