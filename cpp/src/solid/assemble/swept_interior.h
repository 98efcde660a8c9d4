// Tells whether a point lies inside the volume that a body sweeps. Seen from the body, the point
// moves along a curve; it is inside if the curve meets the body.
// In:      the body, triangulated; a trajectory.
// Units:   mm.
// Cost:    O(steps log(triangles)) for a point; turns take some hundred chords each.
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

 private:
  bool isHit(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const;
  bool isInsideBody(const Eigen::Vector3d& point) const;

  TriMesh body_;
  BoxTree tree_;
  Eigen::Vector3d pivot_;
  std::vector<StepPath> steps_;
  std::vector<int> chords_;  // for each step
};

}  // namespace swept::step
