// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/carrier/traces.h"

#include <algorithm>
#include <cmath>

namespace swept::step {
namespace {

using Eigen::Vector3d;

constexpr int kSamplesPerKnotSpan = 6;

// Returns the spline with these points and derivatives at ascending parameters.
Curve hermite(const std::vector<double>& at, const std::vector<CurvePoint>& nodes) {
  Curve curve;
  curve.kind = CurveKind::Spline;
  curve.last = 1;
  curve.poles.push_back(nodes.front().at);
  const double length = at.back() - at.front();
  for (std::size_t i = 0; i < at.size(); ++i) {
    curve.knots.push_back((at[i] - at.front()) / length);
    if (i + 1 == at.size()) break;
    const double third = (at[i + 1] - at[i]) / 3;
    curve.poles.push_back(nodes[i].at + third * nodes[i].slope);
    curve.poles.push_back(nodes[i + 1].at - third * nodes[i + 1].slope);
  }
  curve.knots.back() = 1;
  curve.poles.push_back(nodes.back().at);
  return curve;
}

Vector3d onCubic(double a, const CurvePoint& p, double b, const CurvePoint& q, double t) {
  const double h = b - a, w = (t - a) / h, m = 1 - w;
  return m * m * (1 + 2 * w) * p.at + w * w * (1 + 2 * m) * q.at +
         h * w * m * (m * p.slope - w * q.slope);
}

// Appends the nodes of a spline between two of its parameters, 0 <= from < to <= 1. The parameters
// of the nodes are increased by `shift`.
void addNodes(const Curve& curve, double from, double to, double shift, std::vector<double>& at,
              std::vector<CurvePoint>& nodes) {
  constexpr double kMinKnotGap = 1e-7;
  const auto add = [&](double t) {
    at.push_back(t + shift);
    nodes.push_back({curve.at(t), slopeAt(curve, t)});
  };
  if (at.empty()) add(from);
  for (const double knot : curve.knots) {
    if (knot > from + kMinKnotGap && knot < to - kMinKnotGap) add(knot);
  }
  add(to);
}

}  // namespace

Vector3d slopeAt(const Curve& curve, double t) {
  if (curve.kind == CurveKind::Line) return curve.axis;
  if (curve.kind == CurveKind::Circle) {
    return curve.radius * (std::cos(t) * curve.axis.cross(curve.xdir) - std::sin(t) * curve.xdir);
  }
  std::size_t i = 0;
  while (i + 2 < curve.knots.size() && curve.knots[i + 1] < t) ++i;
  const double a = curve.knots[i], h = curve.knots[i + 1] - a, w = (t - a) / h, m = 1 - w;
  const Vector3d p0 = curve.at(a), p3 = curve.at(a + h);
  const Vector3d &p1 = curve.poles[2 * i + 1], &p2 = curve.poles[2 * i + 2];
  return 3 / h * (m * m * (p1 - p0) + 2 * m * w * (p2 - p1) + w * w * (p3 - p2));
}

bool isClosed(const Curve& curve) {
  if (curve.kind == CurveKind::Line) return false;
  return (curve.at(0) - curve.at(curve.last)).norm() < kKernelTolerance;
}

double nearestParameter(const Curve& curve, const Vector3d& p) {
  if (curve.kind == CurveKind::Line)
    return std::clamp((p - curve.start).dot(curve.axis), 0.0, curve.last);
  const bool closed = isClosed(curve);
  if (curve.kind == CurveKind::Circle) {
    const Vector3d d = p - curve.start;
    double angle = std::atan2(d.dot(curve.axis.cross(curve.xdir)), d.dot(curve.xdir));
    if (angle < 0) angle += 2 * M_PI;
    if (closed || angle <= curve.last) return std::min(angle, curve.last);
    return angle - curve.last < 2 * M_PI - angle ? curve.last : 0;
  }
  double best = 0, smallest = 1e300;
  for (std::size_t i = 0; i + 1 < curve.knots.size(); ++i) {
    for (int k = 0; k <= kSamplesPerKnotSpan; ++k) {
      const double t =
          curve.knots[i] + (curve.knots[i + 1] - curve.knots[i]) * k / kSamplesPerKnotSpan;
      const double d = (curve.at(t) - p).squaredNorm();
      if (d >= smallest) continue;
      smallest = d;
      best = t;
    }
  }
  for (int round = 0; round < 12; ++round) {
    const Vector3d slope = slopeAt(curve, best);
    double next = best - (curve.at(best) - p).dot(slope) / std::max(1e-300, slope.squaredNorm());
    if (closed) next -= std::floor(next);
    next = std::clamp(next, 0.0, curve.last);
    const double step = std::abs(next - best);
    best = next;
    if (step < 1e-14) break;
  }
  return best;
}

Curve pieceOf(const Curve& curve, double from, double to) {
  if (curve.kind == CurveKind::Line) return lineThrough(curve.at(from), curve.at(to));
  if (curve.kind == CurveKind::Circle) {
    Curve piece = curve;
    piece.xdir = (curve.at(from) - curve.start).normalized();
    if (to < from) piece.axis = -piece.axis;
    piece.last = std::abs(to - from);
    return piece;
  }
  std::vector<double> at;
  std::vector<CurvePoint> nodes;
  const double low = std::min(from, to), high = std::max(from, to);
  for (const double turn : {-1.0, 0.0, 1.0}) {
    const double begin = std::max(low - turn, 0.0), end = std::min(high - turn, 1.0);
    if (end - begin > 1e-12) addNodes(curve, begin, end, turn, at, nodes);
  }
  if (to < from) {
    std::reverse(at.begin(), at.end());
    std::reverse(nodes.begin(), nodes.end());
    for (double& t : at) t = -t;
    for (CurvePoint& node : nodes) node.slope = -node.slope;
  }
  return hermite(at, nodes);
}

std::optional<Curve> pieceAlong(const Curve& curve, const std::vector<Vector3d>& points) {
  const double from = nearestParameter(curve, points.front());
  double to = from;
  if (isClosed(curve)) {
    double before = from;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const double now = nearestParameter(curve, points[i]);
      to += std::remainder(now - before, curve.last);
      before = now;
    }
    // Points beside the curve may turn back a little at the ends, so a tolerance is allowed.
    if (!(std::abs(to - from) <= 1.001 * curve.last)) return std::nullopt;
  } else {
    to = nearestParameter(curve, points.back());
  }
  if (!((std::abs(to - from)) > 1e-9 * curve.last)) return std::nullopt;
  Curve piece = pieceOf(curve, from, to);
  if (piece.kind == CurveKind::Spline) {
    piece.poles.front() = points.front();
    piece.poles.back() = points.back();
  }
  if (piece.kind == CurveKind::Line) piece = lineThrough(points.front(), points.back());
  return piece;
}

Curve splineOf(const std::function<CurvePoint(double)>& exact, std::vector<double> breaks,
               double bound) {
  constexpr int kHalvings = 7;
  std::vector<CurvePoint> nodes;
  for (const double t : breaks) nodes.push_back(exact(t));
  for (int round = 0; round < kHalvings; ++round) {
    std::vector<double> finer;
    std::vector<CurvePoint> more;
    for (std::size_t i = 0; i < breaks.size(); ++i) {
      finer.push_back(breaks[i]);
      more.push_back(nodes[i]);
      if (i + 1 == breaks.size()) break;
      const double a = breaks[i], b = breaks[i + 1];
      double off = 0;
      for (const double w : {0.25, 0.5, 0.75}) {
        const double t = a + w * (b - a);
        off = std::max(off, (onCubic(a, nodes[i], b, nodes[i + 1], t) - exact(t).at).norm());
      }
      if (off <= bound) continue;
      finer.push_back(0.5 * (a + b));
      more.push_back(exact(finer.back()));
    }
    const bool done = finer.size() == breaks.size();
    breaks.swap(finer);
    nodes.swap(more);
    if (done) break;
  }
  return hermite(breaks, nodes);
}

Curve asSpline(const Curve& curve, double bound) {
  if (curve.kind == CurveKind::Spline) return curve;
  if (curve.kind == CurveKind::Line)
    return hermite({0, curve.last},
                   {{curve.at(0), curve.axis}, {curve.at(curve.last), curve.axis}});
  // A cubic with the best length of its tangents deviates by 2.7e-4 radii over a quarter circle.
  // The error grows with the sixth power of the angle.
  const double angle =
      std::min(M_PI / 4, M_PI / 2 * std::pow(bound / (2.8e-4 * curve.radius), 1.0 / 6));
  const int count = std::max(1, static_cast<int>(std::ceil(curve.last / angle)));
  const double step = curve.last / count, scale = 4 * std::tan(step / 4) / step;
  std::vector<double> at;
  std::vector<CurvePoint> nodes;
  for (int i = 0; i <= count; ++i) {
    at.push_back(i == count ? curve.last : step * i);
    nodes.push_back({curve.at(at.back()), scale * slopeAt(curve, at.back())});
  }
  return hermite(at, nodes);
}

Curve moved(const Curve& curve, const Eigen::Matrix3d& rotation, const Vector3d& shift) {
  Curve result = curve;
  result.start = rotation * curve.start + shift;
  result.axis = rotation * curve.axis;
  result.xdir = rotation * curve.xdir;
  for (Vector3d& pole : result.poles) pole = rotation * pole + shift;
  return result;
}

}  // namespace swept::step
