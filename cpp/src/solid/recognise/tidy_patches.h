// Patches as they were grown, made ready to become faces.
// In, out: Partition of a mesh; every vertex of a patch stays within the tolerance (mm) of its
// surface, but for a speck of triangles where patches meet. Leftovers beside a patch join it,
// pieces of one surface become one patch, islands inside a patch are filled. Cost: O(triangles x
// rounds).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "solid/mesh/patches.h"

namespace swept::step {

/// What is asked of every triangle again and again.
struct TriangleShapes {
  std::vector<Eigen::Vector3d> normal;  ///< unit; zero without area
  std::vector<double> area;             ///< mm^2
  std::vector<char> thin;               ///< a needle: its normal says little
};
TriangleShapes shapesOf(const HalfEdgeMesh& mesh);

/// A curved patch smaller than this stays facets.
constexpr int kMinTriangles = 24;

/// How many facets the best triangulation of the patch within the tolerance would need, about.
double facetsSaved(const HalfEdgeMesh& mesh, const Patch& patch, double tolerance);

void tidyPatches(const HalfEdgeMesh& mesh, const TriangleShapes& shapes, double tolerance,
                 Partition& partition);

}  // namespace swept::step
