// The motion in the form that samplers use. Its placements are so close together that between two
// of them a straight chord can replace the path of every point.
// Units: mm, s.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace swept {

/// x_world = rotation * x_body + translation
struct Placement {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();
  double timeSeconds = 0;

  Eigen::Vector3d apply(const Eigen::Vector3d& x) const { return rotation * x + translation; }
  /// Returns where the body sees a point in world coordinates.
  Eigen::Vector3d applyInverse(const Eigen::Vector3d& x) const {
    return rotation.transpose() * (x - translation);
  }
};

struct Motion {
  std::vector<Placement> placements;
  /// True: the body moves continuously from placements[i] to placements[i + 1]. False: the
  /// placements are separate copies of the body.
  bool continuous = false;
  /// Exact placement in the middle (in time) of each step; only if continuous. The distance of a
  /// point at this placement from the middle of its chord shows how far the true path deviates.
  std::vector<Placement> midpoints;
  /// Per pose of the trajectory: index of its placement. If the pose lies inside a merged step
  /// (merge_steps.h), index of the placement at the start of this step.
  std::vector<std::uint32_t> poses;
  /// mm, bound on the distance of the true path of any body point from its chord.
  double chordError = 0;
  double mergeError = 0;         ///< mm, the same for merged steps only
  double largestStepTravel = 0;  ///< mm, between successive poses of the trajectory

  std::size_t steps() const { return continuous ? placements.size() - 1 : 0; }
};

}  // namespace swept
