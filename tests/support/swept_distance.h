// Distance from points to a swept volume over continuous time, by an independent method: the
// distance to the body is computed in the body's frame. Its minimum over time is found by
// subdivision, with a bound on the speed of the point in this frame. Shares no code with sampling,
// contouring or motion refinement.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "support/mesh_distance.h"
#include "swept/types.h"

namespace swept::test {

class SweptDistance {
 public:
  /// Intervals of time are split until the point moves less than `finest` (mm) in each of them.
  SweptDistance(const TriMesh& closedBody, const Trajectory& trajectory, double finest);

  struct Contact {
    double distance = 0;             ///< outside: exact; inside: minus a lower bound of the depth
    double time = 0;                 ///< in steps: 2.5 is half way from pose 2 to pose 3
    Eigen::Vector3d point{0, 0, 0};  ///< nearest point of the posed body
    std::vector<Eigen::Vector3d> normals;  ///< possible normals of the envelope there
  };
  Contact contact(const Eigen::Vector3d& x) const;
  double distance(const Eigen::Vector3d& x) const { return contact(x).distance; }

  Eigen::Isometry3d placement(double time) const;
  bool isUnion() const { return !continuous_; }
  double lastTime() const { return static_cast<double>(poses_.size() - 1); }
  /// Returns the velocity (mm per step) of the point that is at x at this time, just before or just
  /// after this time.
  Eigen::Vector3d velocity(double time, const Eigen::Vector3d& x, bool before) const;

  struct Edge {
    std::int32_t a, b;         ///< vertices
    std::int32_t left, right;  ///< triangles
  };
  const std::vector<Edge>& edges() const { return edges_; }
  const MeshDistance& body() const { return tree_; }

 private:
  struct Sample {
    double distance;
    Eigen::Vector3d point;  ///< in the body's frame
    std::int32_t triangle;
  };
  Sample sampleAt(double time, const Eigen::Vector3d& x, double limit) const;
  int featureOf(const Sample& sample, std::int32_t& index) const;
  Eigen::Vector3d pseudoNormal(const Sample& sample) const;

  MeshDistance tree_;
  std::vector<Pose> poses_;
  bool continuous_;
  double finest_;
  std::vector<Edge> edges_;
  /// For each triangle: its edge k starts at its corner k.
  std::vector<std::array<std::int32_t, 3>> edgesOf_;
  std::vector<Eigen::Vector3d> faceNormals_, vertexNormals_;
};

}  // namespace swept::test
