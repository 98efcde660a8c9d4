// Finds the creases of a mesh: edges at which the surface turns by more than 25 degrees, and whose
// two end vertices are feature vertices. A feature vertex lies on a crease or at a corner: its
// quadric, made from the planes of its triangles, has rank 2 or 3.
// Cost:    O(n) for n triangles.
// Order of the result: by the smaller, then the larger vertex.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/raw_array.h"
#include "swept/types.h"

namespace swept {

std::vector<std::array<std::int32_t, 2>> findFeatureEdges(const TriMesh& mesh);
/// Does the same with known opposite half-edges (geometry/half_edges.h).
std::vector<std::array<std::int32_t, 2>> findFeatureEdges(const TriMesh& mesh,
                                                          const RawArray<std::uint32_t>& across);

}  // namespace swept
