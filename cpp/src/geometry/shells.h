// Finds the shells of a mesh (its connected pieces), their boxes and volumes, and how they are
// nested.
// In: a mesh with valid indices. Out: a shell number per triangle; shells are numbered in the order
// of their first triangles. Units: mm.
// Cost: O(n) for n triangles on all cores; a query about nesting takes one ray.
// Promise: numbers and volumes do not depend on the number of threads. A volume is measured from a
// vertex of its own shell, so that a distant origin does not increase the rounding errors.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "geometry/half_edges.h"
#include "geometry/ray_columns.h"
#include "swept/types.h"

namespace swept {

struct Shells {
  std::vector<std::int32_t> ofTriangle;
  std::int32_t count = 0;
};

/// Joins triangles over edges that exactly two triangles share.
Shells shellsByEdges(const RawArray<std::uint32_t>& across);
/// Joins triangles that share a vertex.
Shells shellsByVertices(const TriMesh& mesh);
/// Returns for each vertex the smallest vertex index of its piece. The pieces are those of
/// shellsByVertices(). A vertex without triangles is a separate piece.
std::vector<std::int32_t> smallestJoinedVertices(const TriMesh& mesh);

struct ShellExtent {
  Eigen::AlignedBox3d box;
  double volume = 0;                   ///< mm^3; negative if the normals point inward
  std::int32_t first = -1, last = -1;  ///< first and last triangle
};

std::vector<ShellExtent> measureShells(const TriMesh& mesh, const Shells& shells);

/// Returns whether the inner box lies inside the outer box without touching its sides.
bool liesStrictlyInside(const Eigen::AlignedBox3d& inner, const Eigen::AlignedBox3d& outer);

/// Returns a point inside a triangle. Its barycentric coordinates are no simple fractions, so it
/// seldom lies in a plane of symmetry of the body.
Eigen::Vector3d pointOnTriangle(const TriMesh& mesh, std::int32_t triangle);

/// Finds the shells that contain a point of the mesh, by the parity of a ray's crossings with each
/// shell.
class ShellNesting {
 public:
  /// The arguments must outlive this object.
  ShellNesting(const TriMesh& mesh, const Shells& shells, const RayColumns& columns)
      : mesh_(mesh), shells_(shells), columns_(columns) {}

  /// Returns the shells that contain pointOnTriangle(), except the shell of the triangle, in
  /// ascending order.
  std::vector<std::int32_t> shellsAround(std::int32_t triangle) const;

 private:
  const TriMesh& mesh_;
  const Shells& shells_;
  const RayColumns& columns_;
};

}  // namespace swept
