// Computes those borders between faces of a swept body that are known by a formula. Every other
// border is the intersection of the carriers of its two faces (carrier/carrier.h,
// carrier/section.h).
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

/// Returns the exact iso-line of a sheet: u = `at` (along t) or t = `at` (along u), over `range` of
/// the other parameter.
Curve isoCurve(const Sheet& sheet, bool alongT, double at, Range range);

/// Returns the path of a point of the body: a line, a circle or a spline. Returns nothing if the
/// point is at rest or the bound is not reached.
std::optional<Curve> pathOf(const Eigen::Vector3d& bodyPoint, const StepPath& path, Range during,
                            double bound = kOnCarrier);

/// Returns the curve of the body, placed at one pose.
Curve posed(const Curve& curve, const Placement& placement);
/// Returns the surface of the body, placed at one pose.
Carrier posed(const Carrier& carrier, const Placement& placement);

/// Returns the curve in space through exact points x(v), v in `range`: a line, a circle or a
/// spline. Returns nothing if the bound is not reached.
std::optional<Curve> curveOf(const ExactCurve& exact, Range range, double bound = kOnCarrier);

/// Returns the border between the surface that an edge sweeps and the grazing surface of a face
/// beside it. It is the path of the point of the edge at which n.v = 0 during the step (n: normal,
/// v: velocity). `normalAt`: normal of the face at curve parameter u. `start`: a parameter u near
/// the solution in the middle of `during`. Returns nothing if the solution leaves `along` (by more
/// than a margin) or turns back.
std::optional<Curve> contactAlong(const Curve& curve, Range along,
                                  const std::function<Eigen::Vector3d(double)>& normalAt,
                                  const StepPath& path, Range during, double start,
                                  double bound = kOnCarrier);

/// Returns the contact curve of a smooth face at one time s: the border between the face, placed at
/// this time, and its grazing surface. `along`: two or more points near the curve, from start to
/// end. Returns nothing if the points do not determine the curve or the bound is not reached.
std::optional<Curve> contactAt(const Carrier& face, const std::vector<Eigen::Vector3d>& along,
                               const StepPath& path, double s, double bound = kOnCarrier);

}  // namespace swept::step
