// Finds faces that are unfit for Boolean operations, because an edge does not lie on their surface.
// In:      a Model; faces of patches with numbers below `known` were recognised.
// Out:     ascending indices into Model::faces.
// Units:   mm.
// Cost:    O(edges).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "solid/model/model.h"

namespace swept::step {

/// A face is loose if an edge lies farther from its surface than allowed. Between two recognised
/// faces, `tolerance` (mm) is allowed: surfaces that touch were fitted separately, so no edge lies
/// on both. Otherwise only 1e-7 mm are allowed. Facets are never loose.
std::vector<std::int32_t> findLooseFaces(const Model& model, std::int32_t known, double tolerance);

}  // namespace swept::step
