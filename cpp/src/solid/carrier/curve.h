// Finds curves for edges, and points where carrier surfaces intersect.
// In:      points in order, or carriers.
// Out:     the simplest curve within a tolerance.
// Units:   mm, rad. Ranges of parameters: a line has 0 to its length, a circle 0 to its angle, a
//          spline 0 to `last`.
// Cost:    O(points).
// Source:  circles by linear least squares (Kasa 1976); cubic B-splines (Piegl and Tiller, "The
//          NURBS Book"); polylines (Douglas and Peucker 1973).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <utility>
#include <vector>

#include "solid/carrier/carrier.h"

namespace swept::step {

/// mm: the default tolerance of geometry kernels. Two points closer than this are one, and an edge
/// this near to its faces needs no larger tolerance.
constexpr double kKernelTolerance = 1e-7;

enum class CurveKind { Line, Circle, Spline };

struct Curve {
  CurveKind kind = CurveKind::Line;
  Eigen::Vector3d start = Eigen::Vector3d::Zero();  ///< line: first point; circle: centre
  /// Line: direction; circle: normal of its plane.
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  Eigen::Vector3d xdir = Eigen::Vector3d::UnitX();  ///< circle: direction of its first point
  double radius = 0;
  double last = 0;  ///< end parameter; the first parameter is 0
  /// Spline: a B-spline. By default it consists of cubics that meet with equal derivatives (C1); n
  /// + 1 knots then have 2 n + 2 poles.
  std::vector<Eigen::Vector3d> poles;
  std::vector<double> knots;   ///< distinct knots; the ends have multiplicity degree + 1
  int degree = 3, joints = 2;  ///< `joints`: multiplicity of inner knots

  Eigen::Vector3d at(double t) const;
};

/// Returns the part of a curve from parameter `from` to `to`.
Curve partOf(const Curve& curve, double from, double to);

Curve lineThrough(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

/// Returns the arc or circle within eps (mm) of the ordered points, if there is one.
std::optional<Curve> circleThrough(const std::vector<Eigen::Vector3d>& points, bool closed,
                                   double eps);

/// Returns the spline through these points with these unit tangents.
Curve splineAlong(const std::vector<Eigen::Vector3d>& points,
                  const std::vector<Eigen::Vector3d>& tangents);

/// Returns the profile of an extrusion or a revolution as a curve in space.
Curve profileOf(const Carrier& surface);

/// Returns the simplest of line, circle and spline within eps of the ordered points. `surfaces`:
/// empty, or two that intersect along the curve; their normals then give the tangents of a spline.
Curve curveThrough(std::vector<Eigen::Vector3d> points, bool closed, double eps,
                   const std::vector<const Carrier*>& surfaces);

/// Returns the index, strictly between `from` and `to`, of the point that is farthest from the
/// segment between the points `from` and `to`. `distance` is -1 if there is no index between them.
std::size_t farthestPoint(const std::vector<Eigen::Vector3d>& points, std::size_t from,
                          std::size_t to, double& distance);

/// Marks the points that a polyline must keep to stay within the tolerance of all points. `spans`:
/// pairs of indices between which points are marked; the points at these indices are not marked.
void keepBends(const std::vector<Eigen::Vector3d>& points,
               std::vector<std::pair<std::size_t, std::size_t>> spans, double tolerance,
               std::vector<char>& kept);

/// Returns a line or spline along a jagged polyline, smoothed within the tolerance. The ends stay
/// where they are.
Curve curveAlong(const std::vector<Eigen::Vector3d>& points, bool closed, double tolerance);

/// Returns the point near `from` that lies on all surfaces. In directions that the surfaces do not
/// determine, the point stays near `from`. If two surfaces touch, returns the point where their
/// normals agree.
Eigen::Vector3d meetingPoint(const Eigen::Vector3d& from,
                             const std::vector<const Carrier*>& surfaces);

}  // namespace swept::step
