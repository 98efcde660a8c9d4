// Edge curves, and points where surfaces meet.
// Units: mm, rad. Parameters: Line 0..length, Circle 0..sweep, Spline 0..1.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "solid/carrier/surface.h"

namespace swept::step {

enum class CurveKind { Line, Circle, Spline };

struct Curve {
  CurveKind kind = CurveKind::Line;
  Eigen::Vector3d start = Eigen::Vector3d::Zero();  ///< line: first point; circle: centre
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< line: direction; circle: normal
  Eigen::Vector3d xdir = Eigen::Vector3d::UnitX();  ///< circle: towards its first point
  double radius = 0;
  double last = 0;                     ///< end parameter; the first is 0
  std::vector<Eigen::Vector3d> poles;  ///< cubic B-spline, C1: 2 n + 2 poles for n + 1 knots
  std::vector<double> knots;           ///< distinct; ends have multiplicity 4, inner ones 2

  Eigen::Vector3d at(double t) const;
};

Curve lineThrough(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

/// The profile of an extrusion or a revolution, in space.
Curve profileOf(const Surface& surface);

/// Line, circle or spline through points in order, whichever is the simplest within eps. With
/// `surfaces` (two that meet along the curve) spline tangents come from their normals.
Curve curveThrough(std::vector<Eigen::Vector3d> points, bool closed, double eps,
                   const std::vector<const Surface*>& surfaces);

/// Line or spline along a jagged polyline, smoothed within the tolerance; the ends stay.
Curve curveAlong(const std::vector<Eigen::Vector3d>& points, bool closed, double tolerance);

/// The point near `from` on all surfaces, as far as they determine it; where two of them touch, the
/// point where their normals agree.
Eigen::Vector3d meetingPoint(const Eigen::Vector3d& from,
                             const std::vector<const Surface*>& surfaces);

}  // namespace swept::step
