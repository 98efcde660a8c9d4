// Curves that bound the faces of a swept body, known by a formula; borders between any two other
// carriers are sections (carrier/section.h).
// Units:   mm. All curves are within `bound` of the exact ones.
// Cost:    O(poles).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "solid/sweep/interpolate.h"
#include "solid/sweep/swept_surface.h"

namespace swept::step {

/// An iso-line of a sheet, exactly: u = `at` (along t) or t = `at` (along u), over `range` of the
/// other parameter.
Curve isoCurve(const Sheet& sheet, bool alongT, double at, Range range);

/// The path of a point of the body: a line, a circle or a spline. Nothing if the point is at rest
/// or the bound is not reached.
std::optional<Curve> pathOf(const Eigen::Vector3d& bodyPoint, const StepPath& path, Range during,
                            double bound = kOnCarrier);

/// The curve of the body in its place at one pose.
Curve posed(const Curve& curve, const Placement& placement);
/// The surface of the body in its place at one pose.
Carrier posed(const Carrier& carrier, const Placement& placement);

/// The curve in space through exact points x(v), v in `range`: a line, a circle or a spline.
/// Nothing if the bound is not reached.
std::optional<Curve> curveOf(const ExactCurve& exact, Range range, double bound = kOnCarrier);

/// The border between what an edge sweeps and what a face beside it grazes: the points of the edge
/// at which n.v = 0, followed during the step. `normalAt`: normal of the face at curve parameter u.
/// `start`: a parameter u near the solution in the middle of `during`. Nothing if the solution
/// leaves `along` (by more than a margin) or turns back.
std::optional<Curve> contactAlong(const Curve& curve, Range along,
                                  const std::function<Eigen::Vector3d(double)>& normalAt,
                                  const StepPath& path, Range during, double start,
                                  double bound = kOnCarrier);

/// The contact curve of a smooth face at one moment, the border between the face in its place there
/// and what it grazes. `along`: at least two points near it, in order, from its start to its end.
/// Nothing if the points do not determine it or the bound is not reached.
std::optional<Curve> contactAt(const Carrier& face, const std::vector<Eigen::Vector3d>& along,
                               const StepPath& path, double s, double bound = kOnCarrier);

}  // namespace swept::step
