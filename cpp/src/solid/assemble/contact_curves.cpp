// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/contact_curves.h"

#include <algorithm>
#include <cmath>

namespace swept::step {

using Eigen::Vector3d;
using Kind = BodySurface::Kind;

ContactCurves::ContactCurves(const BodyGeometry& body, int index, const StepPath& path)
    : surface_(body.surfaces[index]),
      path_(path),
      origin_(surface_.origin),
      along_(surface_.axis),
      // The angular velocity is constant in coordinates of the body.
      across_(surface_.axis.cross(Moment(path, 0).angular)),
      size_(across_.norm()) {
  switch (surface_.kind) {
    case Kind::Plane:
      origin_ = surface_.footOfOrigin();
      if (size_ <= kNoSpeed) return;
      count_ = 1;
      across_ /= size_;
      along_ = across_.cross(surface_.axis);
      break;
    case Kind::Cylinder:
      origin_ = surface_.footOfOrigin();
      count_ = 2;
      break;
    case Kind::Cone:
      count_ = 2;
      break;
    case Kind::Torus:
      count_ = 2;
      scale_ = surface_.radius + surface_.tube;
      for (const int curve : {0, 1}) middle_[curve] = middleOf(body, index, curve);
      extent_ = {-M_PI * scale_, M_PI * scale_};
      return;
    case Kind::Other:
      return;
  }
  extent_ = extentOf(body, index);
}

double ContactCurves::middleOf(const BodyGeometry& body, int index, int curve) const {
  constexpr int kAngles = 96, kTimes = 16;
  constexpr double kLarger = 1.05;  // times the face
  struct Extent {
    const BodySurface* surface;
    Eigen::AlignedBox2d range;
  };
  std::vector<Extent> extents;
  for (std::size_t f = 0; f < body.faces.size(); ++f) {
    if (body.faces[f].surface == index)
      extents.push_back({&body.faces[f].own, body.parameterRange(static_cast<int>(f))});
  }
  const auto isOnFace = [&](double angle) {
    for (int i = 0; i <= kTimes; ++i) {
      const Vector3d p = onTorus(curve, angle, static_cast<double>(i) / kTimes);
      if (!p.allFinite()) continue;
      for (const Extent& extent : extents) {
        const Eigen::Vector2d middle = extent.range.center(),
                              off = extent.surface->parametersOf(p, middle) - middle;
        if ((2 * off.cwiseAbs().array() <= kLarger * extent.range.sizes().array()).all())
          return true;
      }
    }
    return false;
  };
  int longest = 0, run = 0, end = 0;
  for (int i = 0; i < 2 * kAngles; ++i) {
    run = isOnFace(2 * M_PI * i / kAngles) ? 0 : run + 1;
    if (run <= longest || run > kAngles) continue;
    longest = run;
    end = i;
  }
  if (longest == 0) return NAN;
  return 2 * M_PI * (end - (longest - 1) / 2.0) / kAngles + M_PI;
}

Vector3d ContactCurves::onTorus(int curve, double angle, double s) const {
  const Moment moment(path_, s);
  const Vector3d velocity = moment.velocityAt(origin_);
  const Vector3d away = std::cos(angle) * surface_.x + std::sin(angle) * surface_.y;
  const Eigen::Vector2d onTube =
      (curve == 0 ? 1 : -1) *
      Eigen::Vector2d(velocity.dot(surface_.axis) + surface_.radius * away.dot(across_),
                      -away.dot(velocity))
          .normalized();
  // Of a sphere, a point behind the axis belongs to the opposite angle.
  const double distance = surface_.radius + surface_.tube * onTube.x();
  if (surface_.radius == 0 && distance < 0) return Vector3d::Constant(NAN);
  return origin_ + distance * away + surface_.tube * onTube.y() * surface_.axis;
}

Vector3d ContactCurves::at(int curve, double w, double s) const {
  if (surface_.kind == Kind::Torus) return onTorus(curve, middle_[curve] + w / scale_, s);
  const Moment moment(path_, s);
  if (surface_.isPlane())
    return origin_ + w * along_ - surface_.axis.dot(moment.linear) / size_ * across_;
  const Vector3d velocity = moment.velocityAt(origin_);
  const double sign = curve == 0 ? 1 : -1, speedAlong = velocity.dot(surface_.axis);
  const double c = std::cos(surface_.slope), e = -std::sin(surface_.slope);
  const double height = w * c, distance = surface_.radius - w * e;
  const Vector3d m =
      c * (velocity - speedAlong * surface_.axis) + (distance * e - height * c) * across_;
  const double size = m.norm(), cosine = -e * speedAlong / size;
  const Vector3d away =
      (cosine * m + sign * std::sqrt(1 - cosine * cosine) * surface_.axis.cross(m)) / size;
  return origin_ + height * surface_.axis + distance * away;
}

double ContactCurves::positionAt(int curve, const Vector3d& p) const {
  switch (surface_.kind) {
    case Kind::Cone:
      return (p - origin_).dot(along_) / std::cos(surface_.slope);
    case Kind::Torus:
      return scale_ * (surface_.parametersOf(p, {middle_[curve], 0}).x() - middle_[curve]);
    default:
      return (p - origin_).dot(along_);
  }
}

int ContactCurves::curveOf(const Vector3d& p, double s) const {
  if (surface_.isPlane()) return 0;
  const auto distance = [&](int curve) {
    const Vector3d there = surface_.kind == Kind::Torus
                               ? onTorus(curve, surface_.parametersOf(p, {0, 0}).x(), s)
                               : at(curve, positionAt(curve, p), s);
    return there.allFinite() ? (there - p).norm() : HUGE_VAL;
  };
  return distance(0) < distance(1) ? 0 : 1;
}

Range ContactCurves::extentOf(const BodyGeometry& body, int index) const {
  constexpr int kPoints = 32;
  Range w{HUGE_VAL, -HUGE_VAL};
  for (const BodyFace& face : body.faces) {
    if (face.surface != index) continue;
    for (const int e : face.edges) {
      const BodyEdge& edge = body.edges[e];
      for (int i = 0; i <= kPoints; ++i)
        w = w.with(positionAt(0, edge.at(edge.range.at(static_cast<double>(i) / kPoints))));
    }
  }
  return w;
}

}  // namespace swept::step
