// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/sweep/borders.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solid/carrier/section.h"
#include "solid/sweep/contact.h"

namespace swept::step {
namespace {

using Eigen::Vector3d;

constexpr int kSamples = 24;
// number of time intervals at whose ends the contact along an edge is found first
constexpr int kNodes = 32;

}  // namespace

Curve isoCurve(const Sheet& sheet, bool alongT, double at, Range range) {
  const Knots& freeKnots = alongT ? sheet.knotsT() : sheet.knotsU();
  const Knots& other = alongT ? sheet.knotsU() : sheet.knotsT();
  const Knots::Basis basis = other.basis(at);
  Curve curve;
  curve.kind = CurveKind::Spline;
  curve.degree = freeKnots.degree();
  curve.joints = freeKnots.joints();
  const double from = freeKnots.range().from;
  for (std::size_t i = 0; i < freeKnots.poleCount(); ++i) {
    Vector3d sum = Vector3d::Zero();
    for (int k = 0; k <= other.degree(); ++k) {
      const std::size_t j = basis.first + k;
      sum += basis.value[0][k] * (alongT ? sheet.pole(j, i) : sheet.pole(i, j));
    }
    curve.poles.push_back(sum);
  }
  for (const double knot : freeKnots.breaks()) curve.knots.push_back(knot - from);
  curve.last = freeKnots.range().length();
  curve = partOf(curve, range.from - from, range.to - from);
  if (curve.degree == 1 && curve.knots.size() == 2)
    return lineThrough(curve.poles.front(), curve.poles.back());
  return curve;
}

std::optional<Curve> curveOf(const ExactCurve& exact, Range range, double bound) {
  std::vector<Vector3d> points;
  double length = 0;
  for (int i = 0; i <= kSamples; ++i) {
    points.push_back(exact(range.at(i / double{kSamples})));
    if (!points.back().allFinite()) return std::nullopt;
    if (i > 0) length += (points[i] - points[i - 1]).norm();
  }
  if (!(length > bound)) return std::nullopt;
  const Curve line = lineThrough(points.front(), points.back());
  const bool isStraight = std::all_of(points.begin(), points.end(), [&](const Vector3d& p) {
    return (p - line.start).cross(line.axis).norm() <= 0.5 * bound;
  });
  // A path that turns back on itself is longer than its chord and is not a line.
  if (isStraight) {
    return length <= line.last + bound ? std::optional<Curve>(line) : std::nullopt;
  }
  const bool closed = (points.front() - points.back()).norm() <= bound;
  if (const auto circle = circleThrough(points, closed, 0.5 * bound)) return circle;
  return fitSpline(exact, range, bound);
}

std::optional<Curve> pathOf(const Vector3d& bodyPoint, const StepPath& path, Range during,
                            double bound) {
  return curveOf([&](double s) { return path.at(s).apply(bodyPoint); }, during, bound);
}

Curve posed(const Curve& curve, const Placement& placement) {
  Curve moved = curve;
  moved.start = placement.apply(curve.start);
  moved.axis = placement.rotation * curve.axis;
  moved.xdir = placement.rotation * curve.xdir;
  for (Vector3d& pole : moved.poles) pole = placement.apply(pole);
  return moved;
}

Carrier posed(const Carrier& carrier, const Placement& placement) {
  Carrier moved = carrier;
  moved.point = placement.apply(carrier.point);
  moved.axis = placement.rotation * carrier.axis;
  moved.xdir = placement.rotation * carrier.xdir;
  if (carrier.sheet) {
    std::vector<Vector3d> poles = carrier.sheet->poles();
    for (Vector3d& pole : poles) pole = placement.apply(pole);
    moved.sheet = std::make_shared<const Sheet>(carrier.sheet->knotsU(), carrier.sheet->knotsT(),
                                                std::move(poles));
  }
  return moved;
}

namespace {

// An edge as a rail: its points, with the normal of a face beside it.
class EdgeRail : public Rails {
 public:
  EdgeRail(const Curve& curve, const std::function<Vector3d(double)>& normalAt)
      : curve_(curve), normalAt_(normalAt) {}
  Point at(double, double v) const override { return {curve_.at(v), normalAt_(v)}; }
  Eigen::Vector2d parametersOf(const Vector3d&) const override { return {0, 0}; }

 private:
  const Curve& curve_;
  const std::function<Vector3d(double)>& normalAt_;
};

}  // namespace

std::optional<Curve> contactAlong(const Curve& curve, Range along,
                                  const std::function<Vector3d(double)>& normalAt,
                                  const StepPath& path, Range during, double start, double bound) {
  const EdgeRail rail(curve, normalAt);
  const double size = (curve.at(along.to) - curve.at(along.from)).norm() +
                      (curve.at(along.at(0.5)) - curve.at(along.from)).norm();
  const ContactMap map(rail, path, size);
  const Range extended = along.grown(kMargin);
  // Solves from the middle of the time range to both of its ends.
  std::vector<double> solutions(kNodes + 1);
  for (const int direction : {-1, 1}) {
    double v = start;
    for (int j = kNodes / 2; j >= 0 && j <= kNodes; j += direction) {
      const auto found = map.solve(0, v, Moment(path, during.at(j / double{kNodes})));
      if (!found || *found < extended.from || *found > extended.to) return std::nullopt;
      solutions[j] = v = *found;
    }
  }
  return curveOf(
      [&](double s) {
        const double x = std::clamp((s - during.from) / during.length(), 0.0, 1.0) * kNodes;
        const int j = std::min(kNodes - 1, static_cast<int>(x));
        const double guess = (1 - (x - j)) * solutions[j] + (x - j) * solutions[j + 1];
        const Moment moment(path, s);
        const auto found = map.solve(0, guess, moment);
        if (!found) return Vector3d::Constant(std::numeric_limits<double>::quiet_NaN()).eval();
        return moment.placement.apply(curve.at(*found));
      },
      during, bound);
}

}  // namespace swept::step
