// Makes sheets that interpolate an exact surface on a grid, and refines them until they are within
// a bound of the surface between the grid points.
// Units:   mm.
// Cost:    O(poles) exact evaluations for the grid and about five times as many to test it.
// Promise: `error` is at most the bound at twice as many test points as poles in each direction.
// The result depends only on the exact values.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "solid/carrier/fit_spline.h"
#include "solid/carrier/sheet.h"

namespace swept::step {

/// Returns a point of the exact surface. Its coordinates are not finite where the surface is
/// undefined.
using ExactSurface = std::function<Eigen::Vector3d(double u, double t)>;

struct FittedSheet {
  std::shared_ptr<const Sheet> sheet;
  double error = 0;  ///< mm, largest deviation at the test points
};

/// Returns a sheet within `bound` of the exact surface. `given`: the knots along u if the exact
/// surface is a spline along u, as for surfaces that a line or a spline sweeps; null: the function
/// searches for knots. Returns nothing if the bound is not reached with kMaxSpans spans and
/// `maxPoles` poles, or if a value is not finite. `degree`: in the directions for which no knots
/// are given.
std::optional<FittedSheet> fitSheet(const ExactSurface& exact, Range u, Range t, const Knots* given,
                                    double bound, std::size_t maxPoles, int degree = kSmoothDegree);

}  // namespace swept::step
