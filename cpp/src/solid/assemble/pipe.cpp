// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/pipe.h"

#include <cmath>

namespace swept::step {

using Eigen::Vector2d;
using Eigen::Vector3d;

Pipe::Pipe(const BodySurface& surface)
    : isCylinder_(surface.isCylinder()),
      origin_(isCylinder_ ? surface.footOfOrigin() : surface.origin),
      x_(surface.x),
      y_(surface.y),
      axis_(surface.axis),
      ring_(isCylinder_ ? 0 : surface.radius),
      radius_(isCylinder_ ? surface.radius : surface.tube) {}

Vector3d Pipe::at(double x, const Vector2d& direction) const {
  const Vector2d off = radius_ * direction;
  if (isCylinder_) return origin_ + x * axis_ + off.x() * x_ + off.y() * y_;
  return origin_ + (ring_ + off.x()) * awayAt(x) + off.y() * axis_;
}

Vector2d Pipe::parametersOf(const Vector3d& p, double near) const {
  const Vector3d off = p - origin_;
  const double along = off.dot(axis_), atX = off.dot(x_), atY = off.dot(y_);
  if (isCylinder_) return {along, std::atan2(atY, atX)};
  const double angle = angleNear(near, std::atan2(atY, atX));
  return {angle, std::atan2(along, off.dot(awayAt(angle)) - ring_)};
}

Vector2d Pipe::speeds(double x, const Moment& moment) const {
  if (isCylinder_) {
    const Vector3d velocity = moment.velocityAt(origin_ + x * axis_);
    return {velocity.dot(x_), velocity.dot(y_)};
  }
  const Vector3d away = awayAt(x), velocity = moment.velocityAt(origin_ + ring_ * away);
  return {velocity.dot(away), velocity.dot(axis_)};
}

Vector2d Pipe::speedChanges(double x, const Moment& moment) const {
  if (isCylinder_) {
    const Vector3d change = moment.angular.cross(axis_);
    return {change.dot(x_), change.dot(y_)};
  }
  const Vector3d away = awayAt(x), along = axis_.cross(away);
  const Vector3d velocity = moment.velocityAt(origin_ + ring_ * away),
                 change = ring_ * moment.angular.cross(along);
  return {velocity.dot(along) + change.dot(away), change.dot(axis_)};
}

}  // namespace swept::step
