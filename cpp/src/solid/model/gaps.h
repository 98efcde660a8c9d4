// Patches that cannot be faces of a solid that others cut: an edge lies off their surface.
// In: a Model; patches below `known` were recognised. Out: patches of faces with such an edge.
// Units: mm. Cost: O(edges).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "solid/model/model.h"

namespace swept::step {

/// Largest gap of an edge between two recognised surfaces that touch without crossing, of the
/// tolerance of the solid: such an edge lies between them, since the surfaces were fitted one by
/// one.
constexpr double kTouchingGap = 0.1;

/// Sorted, without doubles.
std::vector<std::int32_t> findLoosePatches(const Model& model, std::int32_t known,
                                           double tolerance);

}  // namespace swept::step
