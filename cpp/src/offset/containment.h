// Proves that a closed mesh contains a swept volume, and bounds its distance from that volume.
//
// In:    cover of the swept volume (cover.h), a closed mesh, the smallest reach allowed. The reach
//        of a point is its distance to the cover minus the slack of the cover (cover_search.h).
// Out:   bounds that hold for the whole mesh, not only for sample points.
// Method: the reaches of two points differ by at most their distance. So a triangle is far enough
//        away if the reach of its centre exceeds the limit by the triangle's radius. Other
//        triangles are split into four. The distance to one cover triangle, which is convex, is
//        largest at a corner of the mesh triangle. If no point of the mesh is near the cover, every
//        connected piece of the cover is wholly inside or wholly outside. One ray per piece decides
//        this.
// Units: cells. Cost: O(triangles) queries.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>

#include "offset/cover_search.h"
#include "swept/run_context.h"

namespace swept::offset {

struct Containment {
  bool holds = false;
  double nearest = 0;   ///< lower bound of the reach of all points of the mesh (cells)
  double farthest = 0;  ///< upper bound of the distance of all mesh points from the cover (cells)
  std::int64_t tooNear = 0;  ///< triangles for which the proof failed
  std::int64_t outside = 0;  ///< points of Cover::inside that are not inside the mesh
};

/// Tries to prove that the mesh contains the swept volume. `least`: the smallest reach that is
/// allowed for a point of the mesh.
Containment proveContainment(const Cover& cover, const CoverSearch& tree, const TriMesh& mesh,
                             const GridPlan& grid, double least, RunContext& run);

}  // namespace swept::offset
