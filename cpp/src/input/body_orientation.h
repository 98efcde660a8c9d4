// Orients the generator (the moving part). This is the second half of checkBody().
// In:    welded triangles without duplicates. Out: the same triangles, some of them reversed.
// Cost:  O(n) for n triangles, plus three rays for each shell that lies inside the bounding box of
//        another shell.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/half_edges.h"
#include "swept/run_context.h"
#include "swept/types.h"

namespace swept {

struct EdgeCounts {
  std::int64_t open = 0;                                  ///< edges with an odd number of triangles
  std::int64_t nonManifold = 0;                           ///< edges with more than two triangles
  std::vector<std::int64_t> firstOpen, firstNonManifold;  ///< lower vertex of each, at most 8
  std::vector<std::uint8_t> openVertices;  ///< per vertex: 1 if an open edge ends there
};
EdgeCounts countEdges(const EdgeTable& edges);

struct OrientationResult {
  std::int64_t shells = 0;        ///< connected pieces of surface (across edges)
  std::int64_t mixed = 0;         ///< triangles reversed to agree with the rest of their shell
  std::int64_t inverted = 0;      ///< shells reversed as a whole
  std::int64_t cavities = 0;      ///< closed shells that bound a hollow space inside the body
  std::int64_t nested = 0;        ///< closed shells that point outward, wholly inside another shell
  std::int64_t inconsistent = 0;  ///< shells that have no consistent orientation
  bool insideOut = false;         ///< a shell that intersects itself has parts that are inside out
  bool orientable = false;        ///< see CheckedBody
};
/// Reverses triangles of `mesh` where necessary. `edges`: the edges of `mesh`. `closed`: whether
/// every edge has an even number of triangles.
OrientationResult orientShells(TriMesh& mesh, const EdgeTable& edges, bool closed, RunContext& run);

}  // namespace swept
