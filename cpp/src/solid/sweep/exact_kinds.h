// Decides whether a swept surface is a plane, cylinder, cone, sphere, torus, extrusion or
// revolution. A guess from a few points and the motion is kept only if all test points lie on it.
// In:      the exact surface over a range, its motion.
// Out:     the carrier, or nothing. Its outward side is that of S_u x S_t in the middle. It is an
//        extrusion or a revolution only if a profile of few cubics is within the bound.
// Units:   mm.
// Cost:    some hundred exact evaluations; extrusions and revolutions up to some thousand.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>

#include "motion/step_path.h"
#include "solid/carrier/carrier.h"
#include "solid/sweep/interpolate.h"

namespace swept::step {

std::optional<Carrier> exactKind(const ExactSurface& exact, Range u, Range t, const StepPath& path,
                                 double bound);

/// The line about which all points turn and along which they slide in one step, if there is one.
struct FixedAxis {
  Eigen::Vector3d point, direction;
};
std::optional<FixedAxis> fixedAxis(const StepPath& path);

}  // namespace swept::step
