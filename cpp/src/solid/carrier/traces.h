// Traces: curves and points on a carrier that are known before any carriers are intersected.
// Functions of this file cut pieces from such curves, which become edges.
// In:      a curve and points near it.
// Out:     parameters and pieces of the curve.
// Units:   mm. Parameters as in curve.h.
// Cost:    O(spans) per query.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "solid/carrier/curve.h"

namespace swept::step {

struct Traces {
  std::vector<Curve> curves;
  std::vector<Eigen::Vector3d> points;
};

/// Returns the derivative of the curve with respect to its parameter.
Eigen::Vector3d slopeAt(const Curve& curve, double t);

/// Returns whether the curve ends where it begins.
bool isClosed(const Curve& curve);

/// Returns the parameter of the point of the curve that is nearest to p.
double nearestParameter(const Curve& curve, const Eigen::Vector3d& p);

/// Returns the piece of the curve between two parameters. It runs backward if `to` is below `from`.
/// On a closed curve, `to` may lie up to one turn beyond either end.
Curve pieceOf(const Curve& curve, double from, double to);

/// Returns the piece of the curve that runs along the points, from the first to the last one. These
/// two must lie on the curve. Returns nothing if the piece would have no length.
std::optional<Curve> pieceAlong(const Curve& curve, const std::vector<Eigen::Vector3d>& points);

/// A point of a curve and its derivative.
struct CurvePoint {
  Eigen::Vector3d at, slope;
};

/// mm: largest deviation of a spline from the exact curve that it replaces.
constexpr double kCurveError = 1e-8;

/// Returns a spline within `bound` of a curve. It consists of cubics with the points and
/// derivatives of the curve at the breaks. `breaks`: ascending parameters, including both ends.
/// More are added where needed.
Curve splineOf(const std::function<CurvePoint(double)>& exact, std::vector<double> breaks,
               double bound);

/// Returns a circle or line as a spline within `bound`, and a spline unchanged.
Curve asSpline(const Curve& curve, double bound);

/// Returns the curve after a rigid motion.
Curve moved(const Curve& curve, const Eigen::Matrix3d& rotation, const Eigen::Vector3d& shift);

}  // namespace swept::step
