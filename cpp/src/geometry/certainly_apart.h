// Cheap tests whether two triangles of a mesh certainly do not intersect.
//
// In: triangles of one mesh. Out: true only if they certainly do not intersect; the margins are far
// above rounding errors. If the result is false, the triangles may intersect; triangle_pairs.h then
// decides. Cost: about ten nanoseconds, even where the exact predicates are slow (coplanar
// triangles).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "swept/types.h"

namespace swept {

/// A triangle and the normals of the planes that most often separate it from other triangles.
class TriangleSeparator {
 public:
  TriangleSeparator(const TriMesh& mesh, std::int32_t t)
      : TriangleSeparator(mesh.vertices, mesh.triangles[t]) {}
  TriangleSeparator(const std::vector<Eigen::Vector3d>& vertices,
                    const std::array<std::int32_t, 3>& tri) {
    for (int i = 0; i < 3; ++i) corner_[i] = vertices[tri[i]];
    edge_ = {corner_[1] - corner_[0], corner_[2] - corner_[1], corner_[0] - corner_[2]};
    normal_ = edge_[0].cross(edge_[1]);
    size_ = std::max({edge_[0].cwiseAbs().maxCoeff(), edge_[1].cwiseAbs().maxCoeff(),
                      edge_[2].cwiseAbs().maxCoeff()});
  }
  const std::array<Eigen::Vector3d, 3>& corners() const { return corner_; }

  /// Returns true only if the other triangle certainly lies on one side of this triangle's plane.
  bool separatedByPlane(const TriangleSeparator& other) const {
    return separated(normal_, 0, true, other);
  }
  /// Returns true only if the other triangle certainly lies beyond an edge of this one. The test
  /// plane contains the edge and is perpendicular to this triangle.
  bool separatedByEdge(const TriangleSeparator& other) const {
    for (int i = 0; i < 3; ++i) {
      if (separated(edge_[i].cross(normal_), i, false, other)) return true;
    }
    return false;
  }

 private:
  bool separated(const Eigen::Vector3d& axis, int origin, bool bothSides,
                 const TriangleSeparator& other) const {
    constexpr double kMargin = 2e-14;  // about fifty times the rounding error
    double lowest = HUGE_VAL, highest = -HUGE_VAL, reach = size_;
    for (const Eigen::Vector3d& point : other.corner_) {
      const Eigen::Vector3d d = point - corner_[origin];
      const double value = axis.dot(d);
      lowest = std::min(lowest, value);
      highest = std::max(highest, value);
      reach = std::max(reach, d.cwiseAbs().maxCoeff());
    }
    const double margin = kMargin * axis.cwiseAbs().sum() * reach;
    return lowest > margin || (bothSides && highest < -margin);
  }

  std::array<Eigen::Vector3d, 3> corner_, edge_;
  Eigen::Vector3d normal_;
  double size_;
};

/// Returns true only if two triangles certainly share nothing but their common corners and edge.
/// Returns false for two triangles with the same three corners.
bool certainlyApart(const std::vector<Eigen::Vector3d>& vertices,
                    const std::array<std::int32_t, 3>& p, const std::array<std::int32_t, 3>& q);
inline bool certainlyApart(const TriMesh& mesh, std::int32_t first, std::int32_t second) {
  return certainlyApart(mesh.vertices, mesh.triangles[first], mesh.triangles[second]);
}

/// Tests exactly whether a triangle has repeated corners, or all corners on one line.
bool hasNoArea(const std::vector<Eigen::Vector3d>& vertices,
               const std::array<std::int32_t, 3>& triangle);
inline bool hasNoArea(const TriMesh& mesh, std::int32_t triangle) {
  return hasNoArea(mesh.vertices, mesh.triangles[triangle]);
}

}  // namespace swept
