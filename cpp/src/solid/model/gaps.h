// Finds faces that are unfit for Boolean operations, because an edge does not lie on their surface.
// In:      a Model; faces of patches with numbers below `recognisedCount` were recognised.
// Out:     ascending indices into Model::faces.
// Units:   mm.
// Cost:    O(edges).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "solid/model/model.h"

namespace swept::step {

/// Returns the indices of the loose faces. A face is loose if one of its edges lies farther from
/// the surface of the face than allowed. If both faces of the edge are recognised (ModelFace::patch
/// is below `recognisedCount`), `tolerance` (mm) is allowed: their surfaces were fitted separately,
/// so no edge lies exactly on both. Otherwise only 1e-7 mm are allowed. Flat faces of unrecognised
/// parts of the mesh (facets) are never loose.
std::vector<std::int32_t> findLooseFaces(const Model& model, std::int32_t recognisedCount,
                                         double tolerance);

}  // namespace swept::step
