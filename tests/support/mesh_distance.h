// Distance from points to a triangle mesh: a bounding-volume tree, independent of the project's own
// sampling and checking code.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "swept/types.h"

namespace swept::test {

class MeshDistance {
 public:
  explicit MeshDistance(const TriMesh& mesh);

  struct Nearest {
    double distance = 0;
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    std::int32_t triangle = -1;
  };
  /// Returns the nearest point of the mesh within `limit`; if there is none, `triangle` is -1.
  Nearest nearest(const Eigen::Vector3d& p, double limit = 1e300) const;
  double distance(const Eigen::Vector3d& p) const { return nearest(p).distance; }
  /// Returns true if the point lies inside, by the generalised winding number of the triangles.
  bool inside(const Eigen::Vector3d& p) const;
  Eigen::Vector3d normal(std::int32_t triangle) const;
  const TriMesh& mesh() const { return mesh_; }

 private:
  struct Node {
    Eigen::AlignedBox3d box;
    std::int32_t first = 0, count = 0;  ///< triangles of a leaf; count 0: inner node
    std::int32_t left = -1, right = -1;
  };
  std::int32_t build(std::int32_t first, std::int32_t count);

  TriMesh mesh_;
  std::vector<std::int32_t> order_;
  std::vector<Node> nodes_;
  std::vector<Eigen::Vector3d> centres_;
};

}  // namespace swept::test
