// Finds the nearest triangle of a mesh to a point.
//
// In: a finite mesh. Out: the squared distance and the nearest triangle. Units: any one unit of
// length.
// Cost: O(n) to build for n triangles, in parallel, 36 bytes per triangle; O(log n) for a query
// near the mesh.
// Promise: exact up to rounding. If several triangles are equally near, the choice depends only on
// the mesh and the hint, never on threads.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/raw_array.h"
#include "geometry/box_tree.h"
#include "geometry/triangle_distance.h"

namespace swept {

class NearestTriangle {
 public:
  using Triangles = std::vector<std::array<std::int32_t, 3>>;
  /// Whether isNear() may walk from triangle to triangle, which takes 12 more bytes per triangle.
  enum class Walks { No, Yes };
  /// Keeps references to `vertices` and `triangles`; they must outlive this object.
  NearestTriangle(const std::vector<Eigen::Vector3d>& vertices, const Triangles& triangles,
                  Walks walks = Walks::No);

  /// Returns the squared distance from p to the mesh, or `limit` if no triangle is nearer. Stops
  /// early at a squared distance of `enough` or less. `limit` and `enough` are squared distances.
  double query(const Eigen::Vector3d& p, double limit, double enough) const {
    std::int32_t hint = -1;
    return query(p, limit, enough, hint);
  }
  /// Does the same for a series of nearby points. `hint` is the triangle found for the previous
  /// point (-1: none). This triangle is tested first. If it lies within `enough`, no other triangle
  /// is tested. `hint` receives the triangle found.
  double query(const Eigen::Vector3d& p, double limit, double enough, std::int32_t& hint) const;

  /// Returns whether a triangle lies within the squared distance `limit` of p, as query(p,
  /// HUGE_VAL, 0) <= limit does. Walks from the triangle `hint` (-1: none) to ever nearer
  /// neighbours before it searches the tree. For a series of nearby points this takes a fraction of
  /// the time. `hint` receives a triangle near p, within the limit if there is one.
  bool isNear(const Eigen::Vector3d& p, double limit, std::int32_t& hint) const;

 private:
  /// Tests the triangles that are `depth` edges away from the triangle `at`. If a tested triangle
  /// is nearer than `best`, `best` and `hint` receive its squared distance and its index.
  void testNeighbours(const Eigen::Vector3d& p, std::int32_t at, int depth, double limit,
                      double& best, std::int32_t& hint) const;
  double squaredDistanceTo(const Eigen::Vector3d& p, std::int32_t t) const {
    const auto& tri = triangles_[t];
    return squaredDistance(p, vertices_[tri[0]], vertices_[tri[1]], vertices_[tri[2]]);
  }

  const std::vector<Eigen::Vector3d>& vertices_;
  const Triangles& triangles_;
  BoxTree tree_;
  RawArray<std::uint32_t> across_;  ///< by half-edge; empty without walks
};

}  // namespace swept
