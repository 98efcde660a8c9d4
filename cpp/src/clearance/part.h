// A part of a clearance check, in its own frame, prepared once for all poses.
// In:      triangles.
// Out:     their bounding volume hierarchy, nearest point, inside test.
// Units:   mm.
// Cost:    O(n) to build for n triangles, about 220 bytes per triangle; O(log n) per query on
//        well-shaped parts.
// Tessellated solids often have long thin triangles. A box around a long oblique sliver is nearly
// empty, so searches would enter it in vain. So slivers are cut into pieces first, which adds at
// most half as many triangles. All boxes are aligned with the axes of their mesh. One rotation then
// serves all pairs of boxes of two meshes. A box test then takes a fraction of the time of a test
// with individually oriented boxes.
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
  /// Prepares the mesh. `who` names the mesh in messages. Throws Error(InvalidInput) with the code
  /// EmptyMesh, BadIndex or NonFiniteVertex.
  Part(const TriMesh& mesh, const std::string& who);

  const BoxTree& tree() const { return tree_; }
  /// Returns the box of a node. The box of the root is exact; others are rounded outward.
  Box box(BoxTree::Node node) const;
  const Plate* plate(BoxTree::Node node) const { return plates_.of(node); }
  /// Returns the vertices of the triangle, or of the piece of a triangle, at a place (box_tree.h).
  const Triangle3d& corners(std::uint32_t place) const { return corners_[place]; }
  std::int64_t triangle(std::uint32_t place) const { return triangles_[place]; }

  /// Returns whether each edge is used equally often in both directions, so that "inside" is
  /// defined.
  bool closed() const { return rays_.has_value(); }
  /// Returns one surface point of each connected piece.
  const std::vector<Eigen::Vector3d>& pieces() const { return pieces_; }

  /// Returns the nearest surface point. If no point is nearer than `within`, place is -1.
  NearestOnPart nearest(const Eigen::Vector3d& point, double within) const;
  /// Returns whether the winding number of the point is not 0. Always false if the mesh is open.
  bool inside(const Eigen::Vector3d& point) const;
  struct Depth {
    double depth = 0;         ///< mm, positive inside, negative outside
    std::int32_t place = -1;  ///< place of the nearest triangle
  };
  /// Returns the depth below the surface. For a point outside the bounding box, returns only an
  /// upper bound (minus the distance to the box) and no place. `hint`: place of a triangle that is
  /// probably near; -1: none is known.
  Depth depth(const Eigen::Vector3d& point, std::int32_t hint = -1) const;

 private:
  struct Piece {
    Triangle3d corners;
    std::int64_t triangle;
  };
  static std::vector<Piece> cutSlivers(const TriMesh& mesh);

  BoxTree tree_;
  std::vector<Triangle3d> corners_;  ///< by place in the tree
  /// For each place in the tree, the index of its triangle in the mesh.
  std::vector<std::int64_t> triangles_;
  Plates plates_;
  std::vector<Eigen::Vector3d> pieces_;
  /// A pointer, because rays_ refers to this mesh, which must keep its address when the Part is
  /// moved.
  std::unique_ptr<const TriMesh> mesh_;
  std::optional<RayColumns> rays_;  ///< only for closed meshes
};

}  // namespace swept::clearance
