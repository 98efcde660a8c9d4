// Finds the adjacency of a closed triangle mesh, and its shells.
// In:      any TriMesh.
// Out:     HalfEdgeMesh. Half-edge 3 t + k runs from corner k to corner k + 1 of triangle t. A
//          vertex that several fans of triangles share is split, so each vertex has one fan.
// Units:   mm.
// Cost:    O(n log n) for n triangles. Throws Error(ExportFailed, ...) unless the edges form a
//        closed, oriented 2-manifold.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "geometry/half_edges.h"
#include "swept/run_context.h"
#include "swept/types.h"

namespace swept::step {

struct HalfEdgeMesh {
  std::vector<Eigen::Vector3d> points;
  std::vector<std::array<std::int32_t, 3>> triangles;
  std::vector<std::int32_t> opposite;  ///< by half-edge: the opposite one
  std::vector<std::int32_t> shellOf;   ///< by triangle: index of its shell
  /// For each shell: the outer shell around a cavity. For an outer shell: its own index.
  std::vector<std::int32_t> shellOwner;
  double area = 0;    ///< mm^2
  double volume = 0;  ///< mm^3, without the cavities

  static std::int32_t next(std::int32_t h) { return nextHalfEdge(h); }
  static std::int32_t previous(std::int32_t h) { return previousHalfEdge(h); }
  std::int32_t origin(std::int32_t h) const { return triangles[h / 3][h % 3]; }
  std::int32_t target(std::int32_t h) const { return origin(next(h)); }
  /// Returns the triangles beyond the three edges of triangle t.
  std::array<std::int32_t, 3> neighbours(std::int32_t t) const {
    return {opposite[3 * t] / 3, opposite[3 * t + 1] / 3, opposite[3 * t + 2] / 3};
  }
  /// Returns twice the area times the unit normal.
  Eigen::Vector3d areaVector(std::int32_t triangle) const;
};

/// Returns the number of shells that are not cavities, from HalfEdgeMesh::shellOwner.
std::int64_t countOuterShells(const std::vector<std::int32_t>& shellOwner);

HalfEdgeMesh buildHalfEdges(const TriMesh& mesh, RunContext& run);

}  // namespace swept::step
