// Tests whether a sheet is regular: its derivatives S_u and S_t nowhere vanish or become parallel.
// Otherwise the sheet has a pole, a crease or an edge of regression, and kernels cannot work with
// it there.
// Units:   none (sines).
// Cost:    O(samples).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <optional>

#include "solid/carrier/sheet.h"

namespace swept::step {

/// Smallest values allowed: for the sine of the angle between S_u and S_t, and for the length of a
/// derivative relative to the longest one of the sheet.
constexpr double kMinRegular = 0.01;

/// Returns parameters (u, t) within the two ranges at which the sheet is not regular, if there are
/// any. `side`: if given, returns a direction at (u, t). The normal S_u x S_t must then be always
/// along this direction, or always against it.
std::optional<Eigen::Vector2d> findSingular(
    const Sheet& sheet, Range u, Range t,
    const std::function<Eigen::Vector3d(double u, double t)>& side = nullptr);

}  // namespace swept::step
