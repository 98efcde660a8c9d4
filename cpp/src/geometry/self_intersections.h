// Pairs of triangles of one mesh that meet where they should not.
// In:    a finite mesh with valid indices. Out: every such pair, exactly (no tolerance): triangles
//        that touch or cross, neighbours over an edge that lie on one another, triangles round a
//        vertex that share more than it. Triangles without area are left out.
// Cost:  O(n log n) for triangles of similar size; about 150 bytes a triangle.
// Invariants: the same pairs in the same order for any number of threads.
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
  /// Smaller triangle number first, in rising order. Complete unless a part of the mesh has more
  /// than a million pairs: those beyond are only counted.
  std::vector<std::pair<std::int32_t, std::int32_t>> pairs;
};

/// `entangled`: per vertex, 0 where the triangles round it are known to be free of each other
/// (MeshTopology); empty: every vertex is looked at.
SelfIntersections findSelfIntersections(const TriMesh& mesh,
                                        const std::vector<std::uint8_t>& entangled,
                                        RunContext& run);

}  // namespace swept
