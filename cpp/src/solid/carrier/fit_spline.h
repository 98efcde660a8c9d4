// Fits a spline that interpolates an exact curve, and refines it until it is within a bound of the
// curve between the points of interpolation.
// Units:   mm.
// Cost:    about ten exact evaluations per pole.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "solid/carrier/bspline.h"
#include "solid/carrier/curve.h"

namespace swept::step {

/// Degree of curves, and of sheets in curved directions. Rotations are so smooth that degree 5
/// needs a third of the poles of degree 3.
constexpr int kSmoothDegree = 5;
constexpr std::size_t kMaxSpans = 256;

/// Returns a point of the exact curve; its coordinates are not finite where the curve is undefined.
using ExactCurve = std::function<Eigen::Vector3d(double)>;

/// Returns a spline within `bound` of the points exact(v) for v in `range`. The parameter of the
/// spline starts at 0. Returns nothing if kMaxSpans spans do not suffice or a value is not finite.
std::optional<Curve> fitSpline(const ExactCurve& exact, Range range, double bound);

/// Does the same for several curves with the same knots. Every three columns of a row are a point
/// of one of them.
std::optional<std::vector<Curve>> fitSplines(const ExactRow& exact, Range range, double bound);

}  // namespace swept::step
