// Bounding-box hierarchy of a triangle mesh in the mesh's own frame, built once for all poses.
// In:    triangles, mm. Out: the hierarchy; nearest point, inside test.
// Cost:  O(n log n) to build, about 250 bytes a triangle; O(log n) a query on well-shaped parts.
// Long thin triangles, plentiful on tessellated solids, are cut in pieces first (at most half as
// many more): a box round a long oblique sliver is nearly empty and would be opened for nothing.
// The boxes keep the axes of their mesh: one rotation then serves every pair of boxes of two
// meshes, which makes a box test several times cheaper than for boxes with axes of their own.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/triangle_distance.h"
#include "swept/types.h"

namespace swept::clearance {

struct BoxNode {
  Eigen::Vector3d centre;
  Eigen::Vector3d half;
  std::int32_t right = -1;  ///< second child; the first one follows its parent
  std::int32_t leaf = -1;   ///< index into corners(), -1 for inner nodes
};

struct NearestOnMesh {
  double distance = 0;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  std::int32_t leaf = -1;
};

class BoxTree {
 public:
  /// `who` names the mesh in messages. Throws Error(InvalidInput): EmptyMesh, BadIndex,
  /// NonFiniteVertex.
  BoxTree(const TriMesh& mesh, const std::string& who);

  const std::vector<BoxNode>& nodes() const { return nodes_; }
  const Corners& corners(std::int32_t leaf) const { return corners_[leaf]; }
  std::int64_t triangle(std::int32_t leaf) const { return triangles_[leaf]; }
  std::int32_t size() const { return static_cast<std::int32_t>(corners_.size()); }

  /// Every edge is used as often in one direction as in the other, so "inside" has a meaning.
  bool closed() const { return closed_; }
  /// One surface point of every connected piece.
  const std::vector<Eigen::Vector3d>& pieces() const { return pieces_; }

  /// Nearest surface point; `within`: give up beyond this distance (leaf stays -1).
  NearestOnMesh nearest(const Eigen::Vector3d& point, double within) const;
  /// Winding number not zero, by signed crossings of three rays, the majority counts. false if
  /// open.
  bool inside(const Eigen::Vector3d& point) const;
  /// Depth below the surface: positive inside, negative outside. Outside the box only a bound from
  /// above (minus the distance to the box) is returned.
  double depth(const Eigen::Vector3d& point) const;

 private:
  struct Piece {
    Corners corners;
    std::int64_t triangle;
  };
  static std::vector<Piece> cutSlivers(const TriMesh& mesh);
  void build(std::int32_t node, std::int32_t* first, std::int32_t* last,
             const std::vector<Piece>& parts, std::int32_t leafOffset);
  int windingAlong(const Eigen::Vector3d& point, const Eigen::Vector3d& direction) const;

  std::vector<BoxNode> nodes_;
  std::vector<Corners> corners_;
  std::vector<std::int64_t> triangles_;
  std::vector<Eigen::Vector3d> pieces_;
  bool closed_ = false;
};

}  // namespace swept::clearance
