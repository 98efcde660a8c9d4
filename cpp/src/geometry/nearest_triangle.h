// Nearest triangle of a mesh to a point.
// In:      a finite mesh. Out: squared distance and a triangle at it. Units: any one unit of
// length. Cost:    build O(n), in parallel, 36 bytes a triangle; a query O(log n) near the mesh.
// Promise: right to rounding. Which of several equally near triangles is found depends on the mesh
//          and on the hint alone, never on threads.
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
  /// Whether isNear() walks: 12 bytes a triangle more.
  enum class Walks { No, Yes };
  /// Keeps references to both; they must outlive the tree.
  NearestTriangle(const std::vector<Eigen::Vector3d>& vertices, const Triangles& triangles,
                  Walks walks = Walks::No);

  /// Squared distance from p to the mesh. Stops early as soon as a distance of `enough` or less is
  /// found; returns `limit` if nothing lies nearer than that. (All of them squared.)
  double query(const Eigen::Vector3d& p, double limit, double enough) const {
    std::int32_t hint = -1;
    return query(p, limit, enough, hint);
  }
  /// The same for points that follow each other: `hint`, the triangle found last (-1: none), is
  /// looked at first, and where it is near enough no other.
  double query(const Eigen::Vector3d& p, double limit, double enough, std::int32_t& hint) const;

  /// Whether a triangle lies within `limit` (squared) of p: the same as query(p, HUGE_VAL, 0) <=
  /// limit. From `hint` (-1: none) it walks over neighbours that are nearer before it searches the
  /// tree, for points that follow each other a fraction of the time. `hint` receives a triangle
  /// near p, within the limit if there is one.
  bool isNear(const Eigen::Vector3d& p, double limit, std::int32_t& hint) const;

 private:
  /// Triangles `depth` steps from `at`; `best` and `hint` become those of the nearest.
  void lookAround(const Eigen::Vector3d& p, std::int32_t at, int depth, double limit, double& best,
                  std::int32_t& hint) const;
  double squaredDistanceTo(const Eigen::Vector3d& p, std::int32_t t) const {
    const auto& tri = triangles_[t];
    return squaredDistance(p, vertices_[tri[0]], vertices_[tri[1]], vertices_[tri[2]]);
  }

  const std::vector<Eigen::Vector3d>& vertices_;
  const Triangles& triangles_;
  BoxTree tree_;
  RawArray<std::uint32_t> across_;  ///< by half-edge; empty: no walks
};

}  // namespace swept
