// Divides a mesh into patches, each of which becomes one face. A patch is a connected region of the
// mesh on one carrier surface. (A side patch is something else: the surface that a moving edge
// sweeps.)
// In:      HalfEdgeMesh, tolerance.
// Out:     edge-connected sets of triangles. Each vertex of a patch lies within the tolerance of
//          its carrier.
// Units:   mm.
// Cost:    O(n log n) for n triangles.
// Source:  region growing as in Besl and Jain 1988; planes are fitted again while their regions
// grow.
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
  std::int32_t surfaceId = -1;  ///< equal for all pieces of one recognised surface; -1: none
};

/// A plane that cuts a closed surface (such as a cylinder), so that no face needs a seam.
struct Cut {
  std::int32_t surfaceId = -1;
  Carrier plane;
};

struct Partition {
  std::vector<std::int32_t> patchOf;  ///< by triangle; -1: not assigned
  std::vector<Patch> patches;
  std::vector<Cut> cuts;
};

/// Properties of each triangle, computed once.
struct TriangleShapes {
  std::vector<Eigen::Vector3d> normal;  ///< unit; zero for a triangle without area
  std::vector<double> area;             ///< mm^2
  std::vector<double> height;           ///< mm, height over the longest side
  std::vector<char> thin;               ///< 1 for a needle, whose normal is unreliable
};
TriangleShapes shapesOf(const HalfEdgeMesh& mesh);

/// Returns the area of these triangles, mm^2.
double areaOf(const HalfEdgeMesh& mesh, const std::vector<std::int32_t>& triangles);

/// Returns the largest distance of a vertex of these triangles from a surface, mm.
double largestDistance(const HalfEdgeMesh& mesh, const std::vector<std::int32_t>& triangles,
                       const Carrier& surface);

/// Grows plane regions over unassigned triangles. A triangle that remains alone stays unassigned.
void growPlanes(const HalfEdgeMesh& mesh, double tolerance, Partition& partition, RunContext& run);

/// Makes each unassigned triangle a patch of kind Facet, whose plane passes through its vertices.
void addFacets(const HalfEdgeMesh& mesh, Partition& partition);

/// Splits a patch into facets. Used if the kernel does not accept the face.
void dissolvePatch(const HalfEdgeMesh& mesh, std::int32_t patch, Partition& partition);

}  // namespace swept::step
