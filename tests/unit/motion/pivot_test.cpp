// The pivot of a trajectory: it moves straight, and the motion in coordinates of the pivot is
// the same motion.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "motion/pivot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "motion/step_path.h"

namespace swept::test {
namespace {

using Eigen::Vector3d;

const Vector3d kPivot{105, 5, -3};

/// Returns a quarter turn about the z axis, during which the body moves away from the origin.
Trajectory quarterTurn(Interpolation interpolation) {
  Trajectory trajectory;
  trajectory.interpolation = interpolation;
  trajectory.pivot = kPivot;
  const Eigen::Quaterniond turn(std::sqrt(0.5), 0, 0, std::sqrt(0.5));
  trajectory.poses = {{0, Eigen::Quaterniond::Identity(), {1, 2, 3}}, {1, turn, {-40, 7, 9}}};
  return trajectory;
}

TEST(Pivot, GoesStraightAndThePosesStayWhatTheyAre) {
  const Trajectory given = quarterTurn(Interpolation::Linear);
  const Trajectory carried = carriedByPivot(given, pivotOf(given));
  EXPECT_TRUE(carried.pivot.isZero(0));
  const StepPath path(carried.poses[0], carried.poses[1], Interpolation::Linear);
  const auto placeOf = [](const Pose& pose) -> Vector3d {
    return pose.rotation * kPivot + pose.translation;
  };
  const Vector3d from = placeOf(given.poses[0]), to = placeOf(given.poses[1]);
  for (const double s : {0.0, 0.25, 0.5, 0.9, 1.0}) {
    const Pose pose = backFromPivot(path.poseAt(s), kPivot);
    EXPECT_LT((placeOf(pose) - (from + s * (to - from))).norm(), 1e-12) << s;
  }
  for (int end : {0, 1}) {
    const Pose pose = backFromPivot(path.poseAt(end), kPivot);
    EXPECT_LT((pose.translation - given.poses[end].translation).norm(), 1e-12);
  }
}

TEST(Pivot, TheBodyIsSeenFromIt) {
  TriMesh body;
  body.vertices = {kPivot, Vector3d::Zero()};
  const TriMesh seen = seenFromPivot(body, kPivot);
  EXPECT_TRUE(seen.vertices[0].isZero(0));
  EXPECT_EQ(seen.vertices[1], -kPivot);
}

TEST(Pivot, ChangesNothingWhereNoPointGoesStraight) {
  for (const Interpolation kind : {Interpolation::None, Interpolation::Screw})
    EXPECT_TRUE(pivotOf(quarterTurn(kind)).isZero(0));
  EXPECT_EQ(pivotOf(quarterTurn(Interpolation::Linear)), kPivot);
}

TEST(Pivot, BeyondAllMeasureIsRefused) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), HUGE_VAL, 1e10}) {
    Trajectory trajectory = quarterTurn(Interpolation::Screw);
    trajectory.pivot.y() = bad;
    try {
      pivotOf(trajectory);
      FAIL() << bad;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), "BadOption");
    }
  }
}

}  // namespace
}  // namespace swept::test
