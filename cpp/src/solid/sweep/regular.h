// Whether a sheet is regular: S_u and S_t nowhere vanish or become parallel. A sheet that is not
// has a pole, a crease or an edge of regression, where no kernel can work with it.
// Units:   none (sines).
// Cost:    O(samples).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <optional>

#include "solid/carrier/sheet.h"

namespace swept::step {

/// Smallest sine of the angle between S_u and S_t, and smallest ratio of a derivative to the
/// largest one of its kind, of a regular sheet.
constexpr double kLeastRegular = 0.01;

/// Returns where the sheet is not regular, within the two ranges. `side`: if given, the direction
/// to which the normal S_u x S_t must keep at (u, t), on one side or the other all over.
std::optional<Eigen::Vector2d> findSingular(
    const Sheet& sheet, Range u, Range t,
    const std::function<Eigen::Vector3d(double u, double t)>& side = nullptr);

}  // namespace swept::step
