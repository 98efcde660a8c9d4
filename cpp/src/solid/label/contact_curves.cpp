// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/label/contact_curves.h"

#include <algorithm>
#include <cmath>

namespace swept::step {
namespace {

using Eigen::Vector3d;

/// Sine of the largest deviation at which a motion counts as parallel or perpendicular to the axis
/// of a surface.
constexpr double kAlignedSine = 1e-9;

// The range, along the axis of the surface, in which the edges of a face lie, with a margin.
struct Extent {
  double low = 1e300, high = -1e300;
};
Extent extentOf(const BodyShape& body, std::int32_t face) {
  const Carrier& s = body.faces[face].surface;
  Extent extent;
  for (const std::int32_t e : body.faces[face].edges) {
    const Curve& curve = body.edges[e].curve;
    constexpr int kSteps = 16;
    for (int i = 0; i <= kSteps; ++i) {
      const double along = (curve.at(curve.last * i / kSteps) - s.point).dot(s.axis);
      extent.low = std::min(extent.low, along);
      extent.high = std::max(extent.high, along);
    }
  }
  const double margin = 0.02 * (extent.high - extent.low) + 1e-3;
  return {extent.low - margin, extent.high + margin};
}

std::vector<Curve> linesOf(const BodyShape& body, std::int32_t face, const Vector3d& direction) {
  const Carrier& s = body.faces[face].surface;
  const Vector3d across = s.axis.cross(direction);
  if (across.norm() < kAlignedSine) return {};
  const Extent extent = extentOf(body, face);
  if (!(extent.high > extent.low)) return {};
  // On these lines, the normal cosine * radial - sine * axis is perpendicular to the motion.
  const Vector3d x = across.normalized(), y = s.axis.cross(x);
  const double wanted =
      s.kind == CarrierKind::Cone ? std::tan(s.halfAngle) * s.axis.dot(direction) : 0;
  const double ratio = wanted / y.dot(direction);
  if (!(std::abs(ratio) < 1)) return {};
  std::vector<Curve> lines;
  for (const double side : {-1.0, 1.0}) {
    const Vector3d radial = side * std::sqrt(1 - ratio * ratio) * x + ratio * y;
    const auto at = [&](double along) {
      const double grown = s.kind == CarrierKind::Cone ? along * std::tan(s.halfAngle) : 0;
      return Vector3d(s.point + along * s.axis + (s.radius + grown) * radial);
    };
    lines.push_back(lineThrough(at(extent.low), at(extent.high)));
  }
  return lines;
}

Curve circleOf(const Vector3d& centre, const Vector3d& axis, double radius) {
  Curve circle;
  circle.kind = CurveKind::Circle;
  circle.start = centre;
  circle.axis = axis;
  circle.xdir = anyOrthogonal(axis);
  circle.radius = radius;
  circle.last = 2 * M_PI;
  return circle;
}

// With the angles `turn` about the axis and `tube` about the centre circle, the normal of a torus
// is cos(tube) * out(turn) + sin(tube) * axis. On contact curves, it is perpendicular to the
// motion.
std::vector<Curve> torusCurves(const Carrier& s, const Vector3d& direction) {
  const Vector3d x = anyOrthogonal(s.axis), y = s.axis.cross(x);
  const double up = s.axis.dot(direction);
  std::vector<Curve> curves;
  if (std::abs(up) < kAlignedSine) {
    for (const double side : {-1.0, 1.0}) {
      curves.push_back(circleOf(s.point + side * s.minor * s.axis, s.axis, s.radius));
      curves.push_back(circleOf(s.point + side * s.radius * s.axis.cross(direction).normalized(),
                                direction, s.minor));
    }
    return curves;
  }
  for (const double side : {-1.0, 1.0}) {
    const auto at = [&](double turn) {
      const Vector3d out = std::cos(turn) * x + std::sin(turn) * y;
      const double tube = std::atan2(-side * out.dot(direction), side * up);
      return Vector3d(s.point + (s.radius + s.minor * std::cos(tube)) * out +
                      s.minor * std::sin(tube) * s.axis);
    };
    const auto exact = [&](double turn) {
      constexpr double kStep = 1e-4;
      const Vector3d slope = (8 * (at(turn + kStep) - at(turn - kStep)) -
                              (at(turn + 2 * kStep) - at(turn - 2 * kStep))) /
                             (12 * kStep);
      return CurvePoint{at(turn), slope};
    };
    std::vector<double> breaks;
    constexpr int kFirst = 16;
    for (int i = 0; i <= kFirst; ++i) breaks.push_back(2 * M_PI * i / kFirst);
    curves.push_back(splineOf(exact, breaks, kCurveError));
  }
  return curves;
}

}  // namespace

bool slidesAlong(const Carrier& surface, const Vector3d& direction) {
  if (surface.kind == CarrierKind::Plane) return std::abs(surface.axis.dot(direction)) < 1e-8;
  return surface.kind == CarrierKind::Cylinder && surface.axis.cross(direction).norm() < 1e-8;
}

std::vector<Curve> contactCurves(const BodyShape& body, std::int32_t face,
                                 const Vector3d& direction) {
  const Carrier& s = body.faces[face].surface;
  if (slidesAlong(s, direction)) return {};
  switch (s.kind) {
    case CarrierKind::Cylinder:
    case CarrierKind::Cone:
      return linesOf(body, face, direction);
    case CarrierKind::Sphere:
      return {circleOf(s.point, direction, s.radius)};
    case CarrierKind::Torus:
      return torusCurves(s, direction);
    default:
      return {};
  }
}

std::vector<Vector3d> contactPoints(const Curve& curve, const Carrier& surface,
                                    const Vector3d& direction) {
  if (surface.kind == CarrierKind::Facet || surface.isPlanar() || slidesAlong(surface, direction))
    return {};
  const auto normalSpeed = [&](double t) { return surface.normal(curve.at(t)).dot(direction); };
  constexpr int kSteps = 64;
  constexpr double kZero = 1e-9;
  std::vector<Vector3d> points;
  double before = normalSpeed(0);
  for (int i = 1; i <= kSteps; ++i) {
    const double now = normalSpeed(curve.last * i / kSteps);
    if (std::abs(before) > kZero && std::abs(now) > kZero && before * now < 0) {
      double low = curve.last * (i - 1) / kSteps, high = curve.last * i / kSteps;
      for (int round = 0; round < 60; ++round) {
        const double middle = 0.5 * (low + high);
        (normalSpeed(middle) * before > 0 ? low : high) = middle;
      }
      points.push_back(curve.at(0.5 * (low + high)));
    } else if (std::abs(now) <= kZero && i < kSteps && std::abs(before) > kZero) {
      points.push_back(curve.at(curve.last * i / kSteps));
    }
    before = now;
  }
  return points;
}

}  // namespace swept::step
