// Checks a mesh against what an envelope promises.
// In:    any mesh. Out: MeshCheck (swept/report.h): closed, manifold, oriented, finite, counts of
//        every fault, volume, area, self-intersections.
// Units: mm. Cost: O(n log n).
// A mesh is oriented if its triangles pass every edge as often in one direction as in the other,
// and the normals of every shell point away from its material. A shell that lies in an even number
// of others bounds material from outside, any other shell bounds a cavity. A non-manifold vertex
// has more than one fan of triangles; fans end at edges that do not have exactly two triangles.
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

/// As checkMesh() of swept/compute.h; without `withSelfIntersections` those are not counted (-1).
/// Throws Error(InvalidInput, "BadIndex") if a triangle refers to no vertex, and Error(Cancelled).
MeshCheck checkMesh(const TriMesh& mesh, bool withSelfIntersections, RunContext& run);

/// The same, and all pairs of triangles that meet, not only the first ones.
MeshCheck checkMesh(const TriMesh& mesh, SelfIntersections& found, RunContext& run);

/// Everything but self-intersections (-1), and how the mesh hangs together.
MeshCheck checkMesh(const TriMesh& mesh, MeshTopology& topology, RunContext& run);

struct InsideOutShell {
  std::int32_t shell = -1;
  double size = 0;  ///< mm, diagonal of its box
};

/// Shells that do not face away from their material, of a closed mesh without misoriented edges.
std::vector<InsideOutShell> shellsInsideOut(const TriMesh& mesh, const MeshTopology& topology,
                                            RunContext& run);

}  // namespace swept
