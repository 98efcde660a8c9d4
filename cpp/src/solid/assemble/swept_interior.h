// Tells whether a point lies inside the volume that a body sweeps. Seen from the body, the point
// moves along a curve; it is inside if the curve meets the body.
// In:      the body, triangulated; a trajectory.
// Units:   mm.
// Cost:    O(steps log(triangles)) for a point; more if its curve is near the surface of the body.
// Method:  A curve is divided into pieces. Those near triangles are halved until their chords are
//          as accurate as demanded.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "geometry/box_tree.h"
#include "motion/step_path.h"
#include "swept/types.h"

namespace swept::step {

class SweptInterior {
 public:
  /// `accuracy`: mm, how far the triangles may lie from the body. Chords of curved paths are as
  /// accurate.
  SweptInterior(TriMesh body, const Trajectory& trajectory, double accuracy);

  bool contains(const Eigen::Vector3d& point) const;
  double accuracy() const { return accuracy_; }

 private:
  // Where the body sees a point, at a fraction of a step.
  struct PointSeen {
    double s;
    Eigen::Vector3d at;
  };
  struct Piece {
    PointSeen from, to;
  };
  Eigen::Vector3d seen(std::size_t step, double s, const Eigen::Vector3d& point) const;
  // Returns a bound of the second derivative of the curve of a point, in mm. `from`, `to`: its
  // ends.
  double bendOf(std::size_t step, const Eigen::Vector3d& from, const Eigen::Vector3d& to) const;
  bool isHit(std::size_t step, const Eigen::Vector3d& point, const Piece& piece, double bend) const;
  bool isHit(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const;
  bool isInsideBody(const Eigen::Vector3d& point) const;

  TriMesh body_;
  BoxTree tree_;
  double accuracy_;
  Eigen::Vector3d pivot_;
  std::vector<StepPath> steps_;
};

}  // namespace swept::step
