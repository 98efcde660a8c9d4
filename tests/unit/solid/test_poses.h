// Poses for tests of bodies that turn.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Geometry>

#include "swept/types.h"

namespace swept::step {

/// `angle`: rad
inline Pose poseAt(const Eigen::Vector3d& place, double angle, const Eigen::Vector3d& axis) {
  Pose pose;
  pose.translation = place;
  pose.rotation = Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis));
  return pose;
}

}  // namespace swept::step
