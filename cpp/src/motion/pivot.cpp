// SPDX-License-Identifier: LGPL-2.1-or-later
#include "motion/pivot.h"

#include "base/limits.h"
#include "base/number_text.h"

namespace swept {

Eigen::Vector3d pivotOf(const Trajectory& trajectory) {
  const Eigen::Vector3d& pivot = trajectory.pivot;
  if (!pivot.allFinite() || pivot.cwiseAbs().maxCoeff() > kMaxLength) {
    throw Error(Status::InvalidInput, "BadOption",
                "the pivot is (" + numberText(pivot.x()) + ", " + numberText(pivot.y()) + ", " +
                    numberText(pivot.z()) + ") mm; allowed: finite numbers up to 1e9 mm");
  }
  if (trajectory.interpolation != Interpolation::Linear) return Eigen::Vector3d::Zero();
  return pivot;
}

TriMesh seenFromPivot(TriMesh body, const Eigen::Vector3d& pivot) {
  if (pivot.isZero(0)) return body;
  for (Eigen::Vector3d& vertex : body.vertices) vertex -= pivot;
  return body;
}

Trajectory carriedByPivot(Trajectory trajectory, const Eigen::Vector3d& pivot) {
  trajectory.pivot.setZero();
  if (pivot.isZero(0)) return trajectory;
  for (Pose& pose : trajectory.poses) pose.translation += pose.rotation * pivot;
  return trajectory;
}

Pose backFromPivot(Pose pose, const Eigen::Vector3d& pivot) {
  if (!pivot.isZero(0)) pose.translation -= pose.rotation * pivot;
  return pose;
}

}  // namespace swept
