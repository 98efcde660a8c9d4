// Faces that cannot be faces of a solid that others cut: an edge lies off their surface.
// In: a Model; patches below `known` were recognised. Out: indices into Model::faces, in order.
// Units: mm. Cost: O(edges).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "solid/model/model.h"

namespace swept::step {

/// An edge between a facet and another face lies on both, or the other face is loose. An edge
/// between two recognised faces lies within `tolerance` (mm) of both: surfaces that touch were
/// fitted one by one, so that no edge is on both.
std::vector<std::int32_t> findLooseFaces(const Model& model, std::int32_t known, double tolerance);

}  // namespace swept::step
