// Finds how the triangles of a mesh are connected: edges, fans round vertices, shells.
//
// In: triangles with valid indices. Out: counts, neighbours, and the vertices whose triangles must
// be tested for self-intersections.
// Cost: O(n); about 50 bytes a triangle.
// Promise: nothing depends on the number of threads.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/half_edges.h"
#include "geometry/shells.h"
#include "swept/run_context.h"
#include "swept/types.h"

namespace swept {

struct MeshTopology {
  Adjacency adjacency;
  Shells shells;  ///< pieces connected by edges with two triangles
  std::int64_t nonManifoldVertices = 0;
  std::int64_t unusedVertices = 0;
  /// Per vertex: 1 if the triangles round it may intersect. 0 if they certainly do not, because
  /// seen along some direction, they surround the vertex once, like the sectors of a disc. Empty if
  /// not requested.
  std::vector<std::uint8_t> entangled;
};

MeshTopology findTopology(const TriMesh& mesh, bool withEntangled, RunContext& run);

}  // namespace swept
