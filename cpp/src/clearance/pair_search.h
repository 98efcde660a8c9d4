// Two meshes, one of them moving: distance at a pose, and proof that they stay apart for a while.
// In:    two box hierarchies, a pose or a motion node. Units: mm.
// Out:   nearest pair of triangles; or "no pair comes nearer than x anywhere in this node".
// Cost:  proportional to the surface that lies nearer than the distance asked about.
// How a proof works: two convex things, gap g along the unit vector n. If no point of the moving
// one advances by more than a along n, they stay g - a apart (on two sides of a slab). Boxes are
// tried first, then triangles. Sliding along a wall costs nothing: n stands on the wall.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "clearance/motion_tree.h"
#include "clearance/part.h"

namespace swept::clearance {

/// A pair of triangles by their places in the trees; -1: none.
struct LeafPair {
  std::int32_t body = -1;
  std::int32_t neighbour = -1;
};

struct PairDistance {
  double distance = 0;
  LeafPair pair;  ///< none if nothing nearer than asked for was found
  Eigen::Vector3d onBody = Eigen::Vector3d::Zero();       ///< world
  Eigen::Vector3d onNeighbour = Eigen::Vector3d::Zero();  ///< world
};

struct Certificate {
  bool holds = false;
  LeafPair obstacle;    ///< pair that spoilt the proof, none if the effort ran out
  double estimate = 0;  ///< mm, how near the obstacle might come; for ordering only
};

class PairSearch {
 public:
  PairSearch(const Part& body, const Part& neighbour) : body_(body), neighbour_(neighbour) {}

  /// Smallest distance at a pose if below `below`; otherwise distance = below and no pair.
  PairDistance distanceAt(const Eigen::Matrix3d& R, const Eigen::Vector3d& t, double below,
                          LeafPair hint = {}) const;

  /// A pair of triangles nearer than `below` at a pose, not the nearest; none: there is no such
  /// pair.
  LeafPair anyNearerThan(const Eigen::Matrix3d& R, const Eigen::Vector3d& t, double below,
                         LeafPair hint = {}) const;

  /// Tries to show that throughout the node no two points come nearer than `apart` (> 0).
  /// Gives up after `effort` pairs of boxes; `hint` is a pair to try first.
  Certificate certify(const MotionBound& motion, double apart, std::int64_t effort,
                      LeafPair hint = {}) const;

  /// One part has a point of one of its pieces inside the other: they overlap. Where the surfaces
  /// do not meet at this pose, nothing else can make them overlap.
  bool containedAt(const Eigen::Matrix3d& R, const Eigen::Vector3d& t) const;

  /// All pairs of triangles that are at most `apart` from each other at this pose (0: that meet),
  /// at most `limit`.
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
