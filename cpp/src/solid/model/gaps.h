// Patches that cannot be faces of a solid that others cut: an edge lies off their surface.
// In: a Model; patches below `known` were recognised. Out: patches of faces with such an edge.
// Units: mm. Cost: O(edges).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "solid/model/model.h"

namespace swept::step {

/// A face may lie off an edge that it shares with a facet by nothing, and off one that it shares with
/// another recognised face by the tolerance (mm): two surfaces that touch were fitted one by one.
/// Sorted, without doubles.
std::vector<std::int32_t> findLoosePatches(const Model& model, std::int32_t known,
                                           double tolerance);

}  // namespace swept::step
