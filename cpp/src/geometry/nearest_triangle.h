// Nearest point of a triangle mesh: boxes over triangles sorted along a Morton curve, four to a
// node.
// Cost: build O(n log n), a query O(log n) when the point lies near the mesh.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace swept {

double squaredDistance(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                       const Eigen::Vector3d& c);

class NearestTriangle {
 public:
  using Triangles = std::vector<std::array<std::int32_t, 3>>;
  /// Keeps references to both; they must outlive the tree.
  NearestTriangle(const std::vector<Eigen::Vector3d>& vertices, const Triangles& triangles);

  /// Squared distance from p to the mesh. Stops early as soon as a distance of `enough` or less is
  /// found; returns `limit` if nothing lies nearer than that.
  double query(const Eigen::Vector3d& p, double limit, double enough) const {
    std::int32_t hint = -1;
    return query(p, limit, enough, hint);
  }
  /// The same for points that follow each other: `hint`, the triangle found last (-1: none), is
  /// asked first, and where it is near enough no other.
  double query(const Eigen::Vector3d& p, double limit, double enough, std::int32_t& hint) const;

 private:
  struct Box {
    Eigen::Vector3d low, high;
  };
  const std::vector<Eigen::Vector3d>& vertices_;
  const Triangles& triangles_;
  std::vector<std::int32_t> order_;
  std::vector<std::vector<Box>> levels_;  ///< levels_[0]: boxes of four triangles each
};

}  // namespace swept
