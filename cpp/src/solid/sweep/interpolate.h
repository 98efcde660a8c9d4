// Sheets and curves that interpolate an exact surface or curve on a grid, refined until they are
// within a bound between the grid points.
// Units:   mm.
// Cost:    O(poles) exact evaluations for the grid and about five times as many to test it.
// Promise: `error` is at most the bound at twice as many test points as poles in each direction;
//          the result depends on nothing but the exact values.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "solid/carrier/curve.h"
#include "solid/carrier/sheet.h"

namespace swept::step {

/// Degree of curves and of sheets in curved directions. Rotations are so smooth that degree 5 needs
/// a third of the poles of degree 3.
constexpr int kSmoothDegree = 5;
constexpr std::size_t kMostSpans = 64;

/// A point of the exact surface; not finite where it has none.
using ExactSurface = std::function<Eigen::Vector3d(double u, double t)>;
using ExactCurve = std::function<Eigen::Vector3d(double)>;

struct FittedSheet {
  std::shared_ptr<const Sheet> sheet;
  double error = 0;  ///< mm, largest one at the test points
};

/// `isRuled`: the exact surface is straight along u, with even speed. Nothing if the bound is not
/// reached with kMostSpans spans, or if a value is not finite.
std::optional<FittedSheet> fitSheet(const ExactSurface& exact, Range u, Range t, bool isRuled,
                                    double bound);

/// The curve through exact(v), v in `range`; its parameter starts at 0. Nothing as above.
std::optional<Curve> fitSpline(const ExactCurve& exact, Range range, double bound);

}  // namespace swept::step
