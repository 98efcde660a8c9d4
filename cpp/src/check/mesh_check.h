// Checks a mesh against the promises of an envelope.
//
// In: any mesh. Out: MeshCheck (swept/report.h): closed, manifold, oriented, finite, counts of
// every fault, volume, area, self-intersections.
// Units: mm. Cost: O(n log n).
//
// A mesh is oriented if two things hold. Its triangles run along every edge as often in one
// direction as in the other, and the normals of every shell point away from its material. A shell
// inside an even number of other shells bounds material from outside; any other shell bounds a
// cavity. A fan is a group of triangles round a vertex, connected over edges that have exactly two
// triangles. A non-manifold vertex has more than one fan.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "check/mesh_topology.h"
#include "geometry/self_intersections.h"
#include "swept/report.h"
#include "swept/run_context.h"
#include "swept/types.h"

namespace swept {

/// Does the same as checkMesh() of swept/compute.h. Without `withSelfIntersections`, the number of
/// self-intersections in the result is -1. Throws Error(InvalidInput, "BadIndex") if a triangle
/// refers to a missing vertex, and Error(Cancelled).
MeshCheck checkMesh(const TriMesh& mesh, bool withSelfIntersections, RunContext& run);

/// Does the same as checkMesh(mesh, true, run); `found` also receives all pairs of intersecting
/// triangles, not only the first ones.
MeshCheck checkMesh(const TriMesh& mesh, SelfIntersections& found, RunContext& run);

/// Checks everything but self-intersections, whose number in the result is -1. Writes the
/// connectivity to `topology`.
MeshCheck checkMesh(const TriMesh& mesh, MeshTopology& topology, RunContext& run);

struct InsideOutShell {
  std::int32_t shell = -1;
  double size = 0;  ///< diagonal of its box, mm
};

/// Returns the shells whose normals point into their material. The mesh must be closed and have no
/// misoriented edges.
std::vector<InsideOutShell> shellsInsideOut(const TriMesh& mesh, const MeshTopology& topology,
                                            RunContext& run);

}  // namespace swept
