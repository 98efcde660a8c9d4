// Finds pairs of triangles of one mesh that intersect.
//
// In: a finite mesh with valid indices. Out: every such pair, exactly (no tolerance). Triangles
// without a common corner intersect if they touch or cross. Triangles with a common edge or corner
// intersect if they share more than that. Triangles without area are ignored.
// Cost: O(n log n) for n triangles of similar size; about 150 bytes per triangle.
// Promise: the same pairs in the same order for any number of threads.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "swept/run_context.h"
#include "swept/types.h"

namespace swept {

struct SelfIntersections {
  std::int64_t count = 0;
  /// Each pair has the smaller triangle index first; pairs are in ascending order. The list is
  /// complete unless a part of the mesh has more than a million pairs. Further pairs are then only
  /// counted; further pairs with a common corner are not even counted.
  std::vector<std::pair<std::int32_t, std::int32_t>> pairs;
};

/// Finds all pairs. `entangled` (MeshTopology): 0 for each vertex whose triangles are known not to
/// intersect each other. If it is empty, the triangles at all vertices are tested.
SelfIntersections findSelfIntersections(const TriMesh& mesh,
                                        const std::vector<std::uint8_t>& entangled,
                                        RunContext& run);

}  // namespace swept
