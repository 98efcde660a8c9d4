// One of the parts of a clearance check, in its own frame, prepared once for all poses.
// In:    triangles, mm. Out: their hierarchy of boxes; nearest point, inside test.
// Cost:  O(n) to build, about 220 bytes a triangle; O(log n) a query on well-shaped parts.
// Long thin triangles, plentiful on tessellated solids, are cut in pieces first (at most half as
// many more): a box round a long oblique sliver is nearly empty and would be opened for nothing.
// The boxes keep the axes of their mesh: one rotation then serves every pair of boxes of two
// meshes, which makes a box test several times cheaper than for boxes with axes of their own.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "clearance/plates.h"
#include "geometry/box_tree.h"
#include "geometry/ray_columns.h"
#include "geometry/triangle_distance.h"
#include "swept/types.h"

namespace swept::clearance {

struct Box {
  Eigen::Vector3d centre;
  Eigen::Vector3d half;
};

struct NearestOnPart {
  double distance = 0;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  std::int32_t place = -1;
};

class Part {
 public:
  /// `who` names the mesh in messages. Throws Error(InvalidInput): EmptyMesh, BadIndex,
  /// NonFiniteVertex.
  Part(const TriMesh& mesh, const std::string& who);

  const BoxTree& tree() const { return tree_; }
  /// Exact for the root, else rounded outward.
  Box box(BoxTree::Node node) const;
  const Plate* plate(BoxTree::Node node) const { return plates_.of(node); }
  /// Of the triangle, or piece of one, at a place of the tree.
  const Triangle3d& corners(std::uint32_t place) const { return corners_[place]; }
  std::int64_t triangle(std::uint32_t place) const { return triangles_[place]; }

  /// Every edge is used as often in one direction as in the other, so "inside" has a meaning.
  bool closed() const { return rays_.has_value(); }
  /// One surface point of every connected piece.
  const std::vector<Eigen::Vector3d>& pieces() const { return pieces_; }

  /// Nearest surface point; `within`: give up beyond this distance (place stays -1).
  NearestOnPart nearest(const Eigen::Vector3d& point, double within) const;
  /// Winding number not zero. false if open.
  bool inside(const Eigen::Vector3d& point) const;
  /// Depth below the surface: positive inside, negative outside. Outside the box only a bound from
  /// above (minus the distance to the box) is returned.
  double depth(const Eigen::Vector3d& point) const;

 private:
  struct Piece {
    Triangle3d corners;
    std::int64_t triangle;
  };
  static std::vector<Piece> cutSlivers(const TriMesh& mesh);

  BoxTree tree_;
  std::vector<Triangle3d> corners_;      ///< by place, like all below
  std::vector<std::int64_t> triangles_;  ///< of the mesh
  Plates plates_;
  std::vector<Eigen::Vector3d> pieces_;
  std::unique_ptr<const TriMesh> mesh_;  ///< where rays_ finds it when the part moves
  std::optional<RayColumns> rays_;       ///< of closed meshes
};

}  // namespace swept::clearance
