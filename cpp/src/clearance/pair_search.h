// Measures the distance of two meshes at one pose, and proves that they stay apart during a part of
// a motion.
// In:      the bounding volume hierarchies of both meshes; a pose, or a node of the motion's tree.
// Out:     the nearest pair of triangles, or "no pair comes nearer than x anywhere in this node".
// Units:   mm.
// Cost:    proportional to the surface area that is nearer than the distance that is searched for
//        or to be proven.
// Method:  Two convex shapes have the gap g along the unit vector n. If no point of the moving
// shape advances by more than a along n, the shapes stay g - a apart. Boxes are tried first, then
// triangles. A part that slides along a wall causes no extra work, because n is the normal of the
// wall.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "clearance/motion_tree.h"
#include "clearance/part.h"

namespace swept::clearance {

/// A pair of triangles, given by their places (box_tree.h) in the two trees; -1 means none.
struct LeafPair {
  std::int32_t body = -1;
  std::int32_t neighbour = -1;
};

struct PairDistance {
  double distance = 0;
  LeafPair pair;  ///< none if no pair is nearer than the limit of the query
  Eigen::Vector3d onBody = Eigen::Vector3d::Zero();       ///< world
  Eigen::Vector3d onNeighbour = Eigen::Vector3d::Zero();  ///< world
};

struct Certificate {
  bool holds = false;
  LeafPair obstacle;  ///< the pair for which the proof failed; none if the effort ran out
  /// mm, lower bound of the distance to which this pair may come; it orders the search.
  double estimate = 0;
};

class PairSearch {
 public:
  PairSearch(const Part& body, const Part& neighbour) : body_(body), neighbour_(neighbour) {}

  /// Returns the smallest distance at a pose. If this distance is not less than `below`, returns
  /// `below` and no pair.
  PairDistance distanceAt(const Eigen::Matrix3d& R, const Eigen::Vector3d& t, double below,
                          LeafPair hint = {}) const;

  /// Returns some pair of triangles nearer than `below` at a pose (not always the nearest), or none
  /// if no pair is nearer.
  LeafPair anyNearerThan(const Eigen::Matrix3d& R, const Eigen::Vector3d& t, double below,
                         LeafPair hint = {}) const;

  /// Tries to prove that no two points come nearer than `apart` (> 0) anywhere in the node. Gives
  /// up after `effort` pairs of boxes. `hint` is a pair to try first.
  Certificate certify(const MotionBound& motion, double apart, std::int64_t effort,
                      LeafPair hint = {}) const;

  /// Returns whether the solids overlap at this pose because a point of one lies inside the other.
  /// Tests one point of each connected piece, which suffices if the surfaces do not intersect.
  bool containedAt(const Eigen::Matrix3d& R, const Eigen::Vector3d& t) const;

  /// Returns the pairs of triangles that are at most `apart` from each other at this pose, but no
  /// more than `limit` pairs. With apart = 0, these are the pairs that touch or intersect.
  std::vector<LeafPair> pairsWithin(const Eigen::Matrix3d& R, const Eigen::Vector3d& t,
                                    double apart, std::size_t limit) const;

  NearestPoints leafDistance(const Eigen::Matrix3d& R, const Eigen::Vector3d& t,
                             LeafPair pair) const;

  const Part& body() const { return body_; }
  const Part& neighbour() const { return neighbour_; }

 private:
  const Part& body_;
  const Part& neighbour_;
};

}  // namespace swept::clearance
