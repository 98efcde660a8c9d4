// Partition of a mesh into patches that become one face each. (A patch here is a region of the mesh
// on one carrier; what an edge sweeps is called a side patch.)
// In: HalfEdgeMesh, tolerance in mm. Out: edge-connected sets of triangles; each vertex of a patch
// lies within the tolerance of its carrier. Cost: O(n log n).
// Source: region growing as in Besl and Jain 1988, with planes refitted as they grow.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "solid/carrier/carrier.h"
#include "solid/mesh/half_edge.h"

namespace swept::step {

struct Patch {
  Carrier surface;
  std::vector<std::int32_t> triangles;
  double deviation = 0;         ///< mm: largest distance of its mesh vertices from the surface
  std::int32_t surfaceId = -1;  ///< the same for the pieces of one surface that was cut; -1: none
};

/// A plane that cuts a surface which closes on itself, so that no face needs a seam.
struct Cut {
  std::int32_t surfaceId = -1;
  Carrier plane;
};

struct Partition {
  std::vector<std::int32_t> patchOf;  ///< per triangle; -1: not assigned yet
  std::vector<Patch> patches;
  std::vector<Cut> cuts;
};

/// Properties of every triangle that are needed again and again.
struct TriangleShapes {
  std::vector<Eigen::Vector3d> normal;  ///< unit; zero for a triangle without area
  std::vector<double> area;             ///< mm^2
  std::vector<double> height;           ///< mm, over the longest side
  std::vector<char> thin;               ///< a needle, whose normal is unreliable
};
TriangleShapes shapesOf(const HalfEdgeMesh& mesh);

/// mm^2: area of these triangles.
double areaOf(const HalfEdgeMesh& mesh, const std::vector<std::int32_t>& triangles);

/// mm: largest distance of a corner of these triangles from a surface.
double largestDistance(const HalfEdgeMesh& mesh, const std::vector<std::int32_t>& triangles,
                       const Carrier& surface);

/// Grows planes over triangles not yet assigned; a triangle that stays alone becomes a Facet
/// through its corners.
void growPlanes(const HalfEdgeMesh& mesh, double tolerance, Partition& partition, RunContext& run);

/// Makes every triangle that is not assigned a patch of its own.
void addFacets(const HalfEdgeMesh& mesh, Partition& partition);

/// Splits a patch into facets (used where the kernel does not accept the face).
void dissolvePatch(const HalfEdgeMesh& mesh, std::int32_t patch, Partition& partition);

}  // namespace swept::step
