// The way of a body from one pose to the next, and in how many pieces it is followed.
// Units: mm, rad, s. Cost: O(1) a question but for the sphere and the longest edge.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "motion/motion.h"
#include "swept/types.h"

namespace swept {

/// Holds the body.
struct Sphere {
  Eigen::Vector3d centre;
  double radius;
};

Sphere boundingSphere(const TriMesh& body);

/// At any s in [0, 1].
class StepPath {
 public:
  StepPath(const Pose& from, const Pose& to, Interpolation interpolation);

  double angle() const { return angle_; }
  /// Largest distance of a point of the sphere (body frame) from the centre line of rotation.
  double radius(const Sphere& body) const;
  Placement at(double s) const;

 private:
  void findScrewAxis();

  Pose from_, to_;
  bool screw_;
  double angle_ = 0, pitch_ = 0;
  Eigen::Vector3d axis_ = Eigen::Vector3d::UnitZ(), axisPoint_ = Eigen::Vector3d::Zero();
};

double longestEdge(const TriMesh& body);

/// The patch of an edge over a turn (rad) is warped: its two triangles leave the ruled surface by
/// up to this, which bounds on the chords of points do not see.
inline double warpOf(double turn, double edge) { return edge * turn / 4; }

/// Pieces that a step is cut into; not rounded. The chords of points leave their arcs by at most
/// `chord`. So do side patches, as far as `mostPieces` allows.
double piecesOf(double radius, double angle, double longest, double chord, double mostPieces);
/// Many small triangles are flat enough by themselves and too many to be copied often, so the
/// pieces of a step that flatten side patches are limited by what they cost.
double mostPiecesOf(double triangles, std::size_t steps);

}  // namespace swept
