// Cuts the triangles of a closed mesh along polylines that lie near it.
// In:      a closed mesh; points, and paths from one inserted point to another.
// Out:     the mesh, cut so that each path is a chain of its edges. Vertices of paths have two
//          positions: one on the given mesh, on which all searches work, and one on the path.
// Units:   mm.
// Cost:    O(log n) for a point, O(triangles crossed) for a path.
// Method:  A point cuts the triangle or the edge next to it, or takes the place of a vertex. A path
//          follows the plane through its ends and the normal of the mesh. If this plane does not
//          lead to the end, the path takes the shortest way along existing edges.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "geometry/nearest_triangle.h"
#include "solid/mesh/half_edge.h"

namespace swept::step {

class Imprint {
 public:
  /// `snap`: mm, a vertex nearer than this takes the place of a point, instead of a new one. Keeps
  /// a reference to the mesh.
  Imprint(const HalfEdgeMesh& mesh, double snap);

  /// Returns the vertex for a point near the mesh. Nothing if its place is taken.
  std::optional<std::int32_t> insert(const Eigen::Vector3d& p);
  /// Returns the vertices of a path between two vertices, including both. Empty if it
  /// would cross another path. `owner`: of the path, for ownerOf().
  std::vector<std::int32_t> connect(std::int32_t from, std::int32_t to, int owner);
  void move(std::int32_t vertex, const Eigen::Vector3d& to) { points_[vertex] = to; }

  /// Returns for each triangle the region in which it lies. Paths separate the regions.
  std::vector<std::int32_t> regions() const;
  /// Returns the triangle beside the half-edge; -1 if there is no such half-edge.
  std::int32_t triangleBeside(std::int32_t from, std::int32_t to) const;

  const std::vector<Eigen::Vector3d>& points() const { return points_; }
  const std::vector<std::array<std::int32_t, 3>>& triangles() const { return triangles_; }
  /// mm: distance of two vertices on the given mesh.
  double distance(std::int32_t a, std::int32_t b) const { return (on_[a] - on_[b]).norm(); }
  /// Returns the owner of the path along an edge, or -1.
  int ownerOf(std::int32_t a, std::int32_t b) const;
  /// Returns the owner of the path that stopped the last connect(); -1 if none did.
  int stoppedBy() const { return stoppedBy_; }

 private:
  using Corner = std::int32_t;  // half-edge 3 t + k, from corner k of triangle t
  std::int32_t origin(Corner h) const { return triangles_[h / 3][h % 3]; }
  std::int32_t target(Corner h) const { return origin(nextHalfEdge(h)); }
  // Calls use(h) for each half-edge that starts at the vertex, until it returns true.
  template <class Use>
  void around(std::int32_t vertex, const Use& use) const;
  Eigen::Vector3d normalAt(std::int32_t vertex) const;
  std::int32_t splitTriangle(std::int32_t t, const Eigen::Vector3d& p);
  std::int32_t splitEdge(Corner h, const Eigen::Vector3d& p);
  std::int32_t addTriangle(std::int32_t root);
  void link(Corner a, Corner b);
  void setTriangle(std::int32_t t, std::int32_t a, std::int32_t b, std::int32_t c);
  std::int32_t addVertex(const Eigen::Vector3d& p);
  // Returns the next vertex of a path in the plane with the normal `across`.
  std::optional<std::int32_t> step(std::int32_t at, std::int32_t to, const Eigen::Vector3d& along,
                                   const Eigen::Vector3d& across);
  std::vector<std::int32_t> shortestPath(std::int32_t from, std::int32_t to) const;

  double snap_;
  NearestTriangle nearest_;
  std::vector<Eigen::Vector3d> on_, points_;  // by vertex: on the given mesh, on paths
  std::vector<std::array<std::int32_t, 3>> triangles_;
  std::vector<Corner> opposite_;
  std::vector<Corner> firstOf_;                    // by vertex: a half-edge that starts there
  std::vector<std::int32_t> rootOf_;               // by triangle: the triangle of the given mesh
  std::vector<std::vector<std::int32_t>> parts_;   // by triangle of the given mesh
  std::vector<char> isTaken_;                      // by vertex
  std::unordered_map<std::uint64_t, int> owners_;  // by edge of a path
  int stoppedBy_ = -1;
};

}  // namespace swept::step
