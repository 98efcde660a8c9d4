// Pairs of triangles that meet, where only few triangles can be one side of a pair.
// In:    a mesh, the numbers of the few ("members") and of those that they may meet.
// Out:   every pair with at least one member that meets where it should not, exactly as
//        findSelfIntersections() counts them.
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

/// `others` may contain members; a pair of two members is found if both are in `others`.
SelfIntersections findNearPairs(const TriMesh& mesh, const std::vector<std::int32_t>& members,
                                const std::vector<std::int32_t>& others, RunContext& run);

}  // namespace swept
