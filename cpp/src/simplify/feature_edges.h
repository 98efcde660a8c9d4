// Creases of a mesh: edges over which the surface turns, between vertices that are themselves on a
// crease or a corner (rank 2 or 3 of the quadric of the planes round them).
// Cost: O(n). Order: by smaller, then larger vertex.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/raw_array.h"
#include "swept/types.h"

namespace swept {

std::vector<std::array<std::int32_t, 2>> findFeatureEdges(const TriMesh& mesh);
/// The same where the half-edges across (geometry/half_edges.h) are known already.
std::vector<std::array<std::int32_t, 2>> findFeatureEdges(const TriMesh& mesh,
                                                          const RawArray<std::uint32_t>& across);

}  // namespace swept
