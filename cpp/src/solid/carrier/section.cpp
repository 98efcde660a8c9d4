// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/carrier/section.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace swept::step {
namespace {

using Eigen::Vector3d;

/// Sine of 0.17 degrees. At smaller angles between the carriers, rounding decides where they meet.
constexpr double kMinSine = 0.003;
constexpr std::size_t kMinPieces = 4, kMaxPieces = 64;

// Returns the point on both carriers near q. Each step of the iteration is the shortest that, to
// first order, leads to both carriers. Returns nothing if the point moves farther than
// `maxDeviation` (mm).
std::optional<Vector3d> pointOnBoth(const Vector3d& q, const Carrier& a, const Carrier& b,
                                    double maxDeviation) {
  Vector3d p = q;
  for (int round = 0; round < 30; ++round) {
    const double da = a.distance(p), db = b.distance(p);
    if (std::max(std::abs(da), std::abs(db)) < 1e-11) return p;
    const Vector3d na = a.normal(p), nb = b.normal(p);
    const double c = na.dot(nb), sine2 = 1 - c * c;
    if (sine2 < kMinSine * kMinSine) return std::nullopt;
    p -= ((da - c * db) * na + (db - c * da) * nb) / sine2;
    if (!((p - q).norm() <= maxDeviation)) return std::nullopt;
  }
  // Far from the origin, rounding errors exceed the limit of 1e-11. Then a larger distance is
  // accepted.
  const bool isOn = std::max(std::abs(a.distance(p)), std::abs(b.distance(p))) < 0.1 * kOnCarrier;
  return isOn ? std::optional<Vector3d>(p) : std::nullopt;
}

// Returns count + 1 evenly spaced points on a polyline.
std::vector<Vector3d> spaced(const std::vector<Vector3d>& along, std::size_t count) {
  std::vector<double> at{0};
  for (std::size_t i = 1; i < along.size(); ++i)
    at.push_back(at.back() + (along[i] - along[i - 1]).norm());
  std::vector<Vector3d> points{along.front()};
  std::size_t i = 0;
  for (std::size_t k = 1; k < count; ++k) {
    const double wanted = at.back() * static_cast<double>(k) / static_cast<double>(count);
    while (i + 2 < at.size() && at[i + 1] < wanted) ++i;
    const double w = at[i + 1] > at[i] ? (wanted - at[i]) / (at[i + 1] - at[i]) : 0.0;
    points.push_back((1 - w) * along[i] + w * along[i + 1]);
  }
  points.push_back(along.back());
  return points;
}

bool isOnBoth(const Curve& curve, const Carrier& a, const Carrier& b) {
  return largestGap(curve, a) <= kOnCarrier && largestGap(curve, b) <= kOnCarrier;
}

// Returns the direction of the intersection at a point where the carriers touch and two branches of
// the intersection cross. To second order, the difference of the distances from the carriers is a
// quadratic form of the direction. It is zero along the branches. Returns nothing if no branch is
// near the direction `chord`.
std::optional<Vector3d> branchTangent(const Vector3d& p, const Vector3d& chord, double step,
                                      const Carrier& a, const Carrier& b) {
  const Vector3d normal = a.normal(p), x = (chord - chord.dot(normal) * normal).normalized();
  const Vector3d y = normal.cross(x);
  const double side = normal.dot(b.normal(p)) > 0 ? 1 : -1;
  const auto direction = [&](double angle) {
    return Vector3d(std::cos(angle) * x + std::sin(angle) * y);
  };
  const auto difference = [&](const Vector3d& q) { return a.distance(q) - side * b.distance(q); };
  const double here = difference(p);
  const auto secondDifference = [&](double angle) {
    const Vector3d d = step * direction(angle);
    return difference(p + d) + difference(p - d) - 2 * here;
  };
  constexpr double kWidest = 0.6;
  constexpr int kSteps = 24;
  std::optional<double> best;
  for (int i = -kSteps; i < kSteps; ++i) {
    double low = kWidest * i / kSteps, high = kWidest * (i + 1) / kSteps;
    const double atLow = secondDifference(low);
    if (!(atLow * secondDifference(high) <= 0)) continue;
    for (int round = 0; round < 40; ++round) {
      const double middle = 0.5 * (low + high);
      (secondDifference(middle) * atLow > 0 ? low : high) = middle;
    }
    if (!best || std::abs(low) < std::abs(*best)) best = low;
  }
  return best ? std::optional<Vector3d>(direction(*best)) : std::nullopt;
}

// Returns unit tangents of the intersection, in the order of the points. Returns nothing if the
// points turn back.
std::optional<std::vector<Vector3d>> tangentsAt(const std::vector<Vector3d>& points, bool closed,
                                                const Carrier& a, const Carrier& b) {
  std::vector<Vector3d> tangents;
  const std::size_t last = points.size() - 1;
  for (std::size_t i = 0; i <= last; ++i) {
    const Vector3d& before = i > 0 ? points[i - 1] : closed ? points[last - 1] : points[0];
    const Vector3d& after = i < last ? points[i + 1] : closed ? points[1] : points[last];
    const Vector3d cross = a.normal(points[i]).cross(b.normal(points[i]));
    const Vector3d chord = (after - before).normalized();
    Vector3d unit = cross.normalized();
    if (cross.norm() < kMinSine) {
      if (closed || (i > 0 && i < last)) return std::nullopt;
      const auto branch = branchTangent(points[i], chord, 0.01 * (after - before).norm(), a, b);
      if (!branch) return std::nullopt;
      unit = *branch;
    }
    if (!(std::abs(unit.dot(chord)) > 0.7)) return std::nullopt;
    tangents.push_back(unit.dot(chord) > 0 ? unit : Vector3d(-unit));
  }
  return tangents;
}

// Returns the curve in which a plane intersects an extrusion. The curve is an affine image of the
// profile and is computed span by span.
std::optional<Curve> cutProfile(const std::vector<Vector3d>& along, const Carrier& extrusion,
                                const Carrier& plane) {
  // The angle between the plane and the direction of extrusion is at least 3 degrees.
  constexpr double kMinCosine = 0.05;
  const double slope = extrusion.axis.dot(plane.axis);
  const Profile& profile = *extrusion.profile;
  if (std::abs(slope) < kMinCosine || profile.isClosed()) return std::nullopt;
  const Vector3d &x = extrusion.xdir, y = extrusion.axis.cross(x);
  const auto onPlane = [&](const Vector3d& direction) {
    return Vector3d(direction - direction.dot(plane.axis) / slope * extrusion.axis);
  };
  const double from = profile.foot(extrusion.inProfile(along.front())).t;
  const double to = profile.foot(extrusion.inProfile(along.back())).t;
  const double sign = to > from ? 1 : -1;
  std::vector<double> at;
  for (const Profile::Node& node : profile.nodes()) {
    if (sign * (node.knot - from) > kOnCarrier && sign * (to - node.knot) > kOnCarrier)
      at.push_back(node.knot);
  }
  at.push_back(from);
  at.push_back(to);
  std::sort(at.begin(), at.end(), [&](double s, double t) { return sign * s < sign * t; });
  Curve curve;
  curve.kind = CurveKind::Spline;
  curve.last = 1;
  std::vector<Vector3d> points, slopes;
  for (const double t : at) {
    Eigen::Vector2d first, second;
    profile.derivatives(t, first, second);
    const Eigen::Vector2d q = profile.at(t);
    const Vector3d p = extrusion.point + q.x() * x + q.y() * y;
    points.push_back(p - plane.distance(p) / slope * extrusion.axis);
    slopes.push_back(onPlane(first.x() * x + first.y() * y));
    curve.knots.push_back((t - from) / (to - from));
  }
  points.front() = along.front();
  points.back() = along.back();
  curve.poles.push_back(points.front());
  for (std::size_t i = 0; i + 1 < at.size(); ++i) {
    const double third = (at[i + 1] - at[i]) / 3;
    curve.poles.push_back(points[i] + third * slopes[i]);
    curve.poles.push_back(points[i + 1] - third * slopes[i + 1]);
  }
  curve.poles.push_back(points.back());
  return curve;
}

}  // namespace

double largestGap(const Curve& curve, const Carrier& carrier) {
  // A straight edge is farthest from a plane at its ends. Other curves are sampled at no fewer
  // points than a kernel checks, with some points in each span.
  const bool flat = curve.kind == CurveKind::Line && carrier.isPlanar();
  const std::size_t steps = flat ? 1 : std::max<std::size_t>(24, 4 * curve.knots.size());
  double largest = 0;
  for (std::size_t i = 0; i <= steps; ++i) {
    const double t = curve.last * static_cast<double>(i) / static_cast<double>(steps);
    largest = std::max(largest, std::abs(carrier.distance(curve.at(t))));
  }
  return largest;
}

std::optional<Curve> sectionCurve(std::vector<Vector3d> along, bool closed, const Carrier& a,
                                  const Carrier& b, double maxDeviation) {
  for (const auto& [extrusion, plane] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    if (closed || extrusion->kind != CarrierKind::Extrusion || !plane->isPlanar()) continue;
    const Curve line = lineThrough(along.front(), along.back());
    if (isOnBoth(line, a, b)) return line;
    const auto curve = cutProfile(along, *extrusion, *plane);
    if (curve && isOnBoth(*curve, a, b)) return curve;
  }
  for (std::size_t spans = kMinPieces; spans <= kMaxPieces; spans *= 2) {
    std::vector<Vector3d> points = spaced(along, spans);
    for (std::size_t i = 0; i <= spans; ++i) {
      if (!closed && (i == 0 || i == spans)) continue;
      const auto moved = pointOnBoth(points[i], a, b, maxDeviation);
      if (!moved) return std::nullopt;
      points[i] = *moved;
    }
    if (closed) points.back() = points.front();
    if (!closed) {
      const Curve line = lineThrough(points.front(), points.back());
      if (isOnBoth(line, a, b)) return line;
    }
    if (spans > kMinPieces) {
      const auto circle = circleThrough(points, closed, kOnCarrier);
      if (circle && isOnBoth(*circle, a, b)) return circle;
    }
    const auto tangents = tangentsAt(points, closed, a, b);
    if (!tangents) return std::nullopt;
    Curve spline = splineAlong(points, *tangents);
    if (isOnBoth(spline, a, b)) return spline;
    along.clear();
    for (std::size_t i = 0; i <= 8 * spans; ++i)
      along.push_back(spline.at(static_cast<double>(i) / static_cast<double>(8 * spans)));
  }
  return std::nullopt;
}

}  // namespace swept::step
