// How the triangles of a mesh hang together: edges, fans round vertices, shells.
// In:    triangles with valid indices. Out: counts, neighbours, and the vertices that need a closer
//        look for self-intersections.
// Cost:  O(n); about 50 bytes a triangle.
// Invariants: nothing depends on the number of threads.
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
  Shells shells;  ///< pieces joined by edges of two triangles
  std::int64_t nonManifoldVertices = 0;
  std::int64_t unusedVertices = 0;
  /// 1: the triangles round this vertex are not known to be free of each other. All others, seen
  /// along some direction, lie round their vertex like the sectors of a disc, once round. Empty if
  /// not asked for.
  std::vector<std::uint8_t> entangled;
};

MeshTopology findTopology(const TriMesh& mesh, bool withEntangled, RunContext& run);

}  // namespace swept
