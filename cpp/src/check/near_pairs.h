// Finds pairs of intersecting triangles with at least one triangle from a small set.
//
// In: a mesh, the triangles of the small set ("members"), and the triangles that they may intersect
// ("others").
// Out: every intersecting pair with at least one member, exactly as findSelfIntersections() counts
// them.
// Units: any one unit of length. Cost: O(n log n) for n members, O(log n) for each of the others.
// Promise: the same pairs in the same order for any number of threads.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/self_intersections.h"
#include "swept/run_context.h"
#include "swept/types.h"

namespace swept {

/// Finds the pairs. `others` may contain members; a pair of two members is found if `others`
/// contains both.
SelfIntersections findNearPairs(const TriMesh& mesh, const std::vector<std::int32_t>& members,
                                const std::vector<std::int32_t>& others, RunContext& run);

}  // namespace swept
