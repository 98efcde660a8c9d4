// Shells: the connected pieces of a mesh, their boxes and volumes, and how they lie in one another.
// In:    a mesh with valid indices. Out: a shell number per triangle; shells are numbered by their
//        first triangles. Units: mm.
// Cost:  O(n) on all cores; a query about nesting takes one ray.
// Invariants: numbers and volumes do not depend on the number of threads; a volume is measured from
//        a vertex of its own shell, so that a place far from the origin costs no digits.
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

/// Triangles joined by edges that exactly two of them share.
Shells shellsByEdges(const RawArray<std::uint32_t>& across);
/// Triangles joined by the vertices that they share.
Shells shellsByVertices(const TriMesh& mesh);
/// Per vertex the smallest vertex of its piece, pieces as of shellsByVertices(); a vertex without
/// triangles is a piece.
std::vector<std::int32_t> smallestJoinedVertices(const TriMesh& mesh);

struct ShellExtent {
  Eigen::AlignedBox3d box;
  double volume = 0;                   ///< mm^3, signed: negative if the normals look inward
  std::int32_t first = -1, last = -1;  ///< triangles
};

std::vector<ShellExtent> measureShells(const TriMesh& mesh, const Shells& shells);

/// True if the inner box lies inside the outer one and touches none of its sides.
bool liesStrictlyInside(const Eigen::AlignedBox3d& inner, const Eigen::AlignedBox3d& outer);

/// A point inside a triangle, in general position: no simple fraction of its corners.
Eigen::Vector3d pointOnTriangle(const TriMesh& mesh, std::int32_t triangle);

/// Says which shells a point of the mesh lies in, by the parity of a ray's crossings with each.
class ShellNesting {
 public:
  /// The mesh and the shells have to outlive this.
  ShellNesting(const TriMesh& mesh, const Shells& shells, const RayColumns& columns)
      : mesh_(mesh), shells_(shells), columns_(columns) {}

  /// The shells round pointOnTriangle(), without the triangle's own, in rising order.
  std::vector<std::int32_t> shellsAround(std::int32_t triangle) const;

 private:
  const TriMesh& mesh_;
  const Shells& shells_;
  const RayColumns& columns_;
};

}  // namespace swept
