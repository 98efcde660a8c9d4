// Makes grown patches ready to become faces.
// In, out: Partition of a mesh. Units: mm. Cost: O(triangles x rounds). Promise: every vertex of a
// patch stays within the tolerance of its surface, except for a few small triangles where patches
// meet.
// Leftover triangles beside a patch join it, pieces of one surface become one patch, islands inside
// a patch are filled, and patches that cost more facets than they save are dropped.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "solid/mesh/patches.h"

namespace swept::step {

/// Properties of every triangle that are needed again and again.
struct TriangleShapes {
  std::vector<Eigen::Vector3d> normal;  ///< unit; zero for a triangle without area
  std::vector<double> area;             ///< mm^2
  std::vector<char> thin;               ///< a needle, whose normal is unreliable
};
TriangleShapes shapesOf(const HalfEdgeMesh& mesh);

/// A curved patch smaller than this becomes facets.
constexpr int kMinTriangles = 24;

void tidyPatches(const HalfEdgeMesh& mesh, const TriangleShapes& shapes, double tolerance,
                 Partition& partition);

}  // namespace swept::step
