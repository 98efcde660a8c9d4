// Orientation of the generator, the second half of the body check.
// In:    welded triangles without duplicates. Out: the same triangles, some of them turned over.
// Cost:  O(n), plus one ray a shell where shells lie inside each other's boxes.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/half_edges.h"
#include "swept/run_context.h"
#include "swept/types.h"

namespace swept {

struct EdgeCounts {
  std::int64_t open = 0;                                  ///< odd number of triangles
  std::int64_t nonManifold = 0;                           ///< more than two triangles
  std::vector<std::int64_t> firstOpen, firstNonManifold;  ///< smaller vertex of the edge, at most 8
  std::vector<std::uint8_t> openVertices;                 ///< 1: ends an open edge
};
EdgeCounts countEdges(const EdgeTable& edges);

struct OrientationResult {
  std::int64_t shells = 0;        ///< pieces that share edges
  std::int64_t mixed = 0;         ///< triangles turned to agree with the rest of their shell
  std::int64_t inverted = 0;      ///< shells turned as a whole
  std::int64_t cavities = 0;      ///< closed shells that bound a hollow space from outside of it
  std::int64_t nested = 0;        ///< closed shells wholly inside another one, normals outward
  std::int64_t inconsistent = 0;  ///< shells that have no consistent orientation
  bool insideOut = false;         ///< parts of a shell are inside out where it crosses itself
  bool orientable = false;        ///< see CheckedBody
};
/// `edges` are those of `mesh`; `closed`: every edge has an even number of triangles.
OrientationResult orientShells(TriMesh& mesh, const EdgeTable& edges, bool closed, RunContext& run);

}  // namespace swept
