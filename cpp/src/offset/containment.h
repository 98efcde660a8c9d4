// Proof that a closed mesh contains a swept volume, and how far it lies from it at most.
//
// In:    cover of the swept volume, a closed mesh, the least distance wanted. Out: bounds over the
//        whole mesh, not samples of it.
// Method: the reach changes by at most the distance between two points: a triangle whose middle is
//        farther away than its radius does not come near; others are quartered. The distance to one
//        convex piece of the cover is largest at a corner. If no point of the mesh is near the
//        cover, every connected piece of the cover is wholly inside or wholly outside; a ray from
//        one of its points decides.
// Units: cells. Cost: O(triangles) queries.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>

#include "offset/cover_search.h"
#include "swept/run_context.h"

namespace swept::offset {

struct Containment {
  bool holds = false;
  double nearest = 0;        ///< no point of the mesh has less reach than this (cells)
  double farthest = 0;       ///< every point of the mesh is at most this far from the cover (cells)
  std::int64_t tooNear = 0;  ///< triangles for which the proof failed
  std::int64_t outside = 0;  ///< pieces of the cover that are not inside
};

/// least: the reach that every point of the mesh must have at least.
Containment proveContainment(const Cover& cover, const CoverSearch& tree, const TriMesh& mesh,
                             const GridPlan& grid, double least, RunContext& run);

}  // namespace swept::offset
