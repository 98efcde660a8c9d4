// Partition of a mesh into regions that become one face each.
// In: HalfEdgeMesh, tolerance in mm. Out: one patch per triangle set, edge-connected, each vertex
// of a patch within the tolerance of its surface. Cost: O(n log n).
//
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "solid/carrier/surface.h"
#include "solid/mesh/half_edge.h"

namespace swept::step {

struct Patch {
  Surface surface;
  std::vector<std::int32_t> triangles;
  double deviation = 0;         ///< mm: largest distance of its mesh vertices from the surface
  std::int32_t surfaceId = -1;  ///< the same for the pieces of one surface that was cut; -1: none
};

/// A surface that goes all the way round is cut by planes, so that no face needs a seam.
struct Cut {
  std::int32_t surfaceId = -1;
  Surface plane;
};

struct Partition {
  std::vector<std::int32_t> patchOf;  ///< per triangle; -1 while not assigned
  std::vector<Patch> patches;
  std::vector<Cut> cuts;
};

/// Grows planes over triangles not yet assigned; what stays alone becomes a Facet through its
/// corners.
void growPlanes(const HalfEdgeMesh& mesh, double tolerance, Partition& partition, RunContext& run);

/// Every triangle that is not assigned becomes a patch of its own.
void addFacets(const HalfEdgeMesh& mesh, Partition& partition);

/// Splits a patch into facets (used where the kernel does not accept the face).
void dissolvePatch(const HalfEdgeMesh& mesh, std::int32_t patch, Partition& partition);

}  // namespace swept::step
