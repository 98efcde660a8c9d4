// The motion of a body at one time. A face of the body touches the envelope where its normal is
// orthogonal to the velocity.
// Units:   mm, rad.
// Cost:    O(1).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "motion/step_path.h"

namespace swept::step {

/// Speeds and areas below this fraction of the largest possible ones count as zero.
constexpr double kNoSpeed = 1e-9;

/// The motion at one time, in coordinates of the body: a point p has the velocity linear + angular
/// x p.
struct Moment {
  /// `s`: fraction of the step, from 0 to 1.
  Moment(const StepPath& path, double s);
  Eigen::Vector3d velocityAt(const Eigen::Vector3d& x) const { return linear + angular.cross(x); }
  Placement placement;
  Eigen::Vector3d linear, angular;  // per unit of s, in coordinates of the body
};

}  // namespace swept::step
