// Creases of a mesh: edges over which the surface turns, between vertices that are themselves on a
// crease or a corner (rank 2 or 3 of the quadric of the planes round them).
// Cost: O(n). Order: by smaller, then larger vertex.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "swept/types.h"

namespace swept {

std::vector<std::array<std::int32_t, 2>> findFeatureEdges(const TriMesh& mesh);

}  // namespace swept
