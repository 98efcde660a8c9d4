// The motion as the samplers see it: placements so close that points move along chords.
// Units: mm, s.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace swept {

/// x_world = rotation * x + translation
struct Placement {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();
  double timeSeconds = 0;

  Eigen::Vector3d apply(const Eigen::Vector3d& x) const { return rotation * x + translation; }
};

struct Motion {
  std::vector<Placement> placements;
  /// placements[i] -> placements[i+1] is swept continuously; false: a union of posed copies.
  bool continuous = false;
  /// Placement in the middle of each step (continuous only): how the true path leaves the chord.
  std::vector<Placement> midpoints;
  std::vector<std::uint32_t> poses;  ///< per pose of the trajectory: its placement
  double chordError = 0;             ///< mm, bound on how far any body point leaves its chord
  double largestStepTravel = 0;      ///< mm, between the poses as given

  std::size_t steps() const { return continuous ? placements.size() - 1 : 0; }
};

}  // namespace swept
