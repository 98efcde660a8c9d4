// Rows 16 to 23 of the table of bad input, on checkTrajectory() and checkOptions() alone.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "input/trajectory_check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "input/options_check.h"
#include "support/shapes.h"

namespace swept::test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Trajectory threePoses() {
  Trajectory trajectory;
  for (int i = 0; i < 3; ++i) {
    trajectory.poses.push_back(poseOf(i, placement({1, 2, 3}, 20.0 * i, {1.0 * i, 0, 2.0 * i})));
  }
  return trajectory;
}

void expectRefused(const Trajectory& trajectory, const std::string& code,
                   const std::string& words) {
  try {
    checkTrajectory(trajectory);
    FAIL() << "not refused: " << code;
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), Status::InvalidInput);
    EXPECT_EQ(error.code(), code);
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

TEST(TrajectoryCheck, GoodMotionPassesUnchanged) {
  const CheckedTrajectory checked = checkTrajectory(threePoses());
  EXPECT_TRUE(checked.findings.empty());
  ASSERT_EQ(checked.trajectory.poses.size(), 3u);
  EXPECT_EQ(checked.trajectory.poses[2].translation, threePoses().poses[2].translation);
}

TEST(TrajectoryCheck, bad_input_16_options) {
  auto refused = [](auto&& change, const std::string& name) {
    Options options;
    change(options);
    try {
      checkOptions(options);
      ADD_FAILURE() << "not refused: " << name;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), "BadOption");
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
    }
  };
  EXPECT_NO_THROW(checkOptions(Options{}));
  refused([](Options& o) { o.cellSize = -1; }, "the cell size is -1 mm; allowed");
  refused([](Options& o) { o.cellSize = 0; }, "the cell size is 0 mm; allowed");
  refused([](Options& o) { o.cellSize = kNan; }, "the cell size is nan mm; allowed");
  refused([](Options& o) { o.cellSize = HUGE_VAL; }, "the cell size is inf mm; allowed");
  refused([](Options& o) { o.resolution = 0; }, "the resolution is 0; allowed");
  refused([](Options& o) { o.resolution = -5; }, "the resolution is -5; allowed");
  refused([](Options& o) { o.tolerance = -1e-3; }, "tolerance");
  refused([](Options& o) { o.offset = kNan; }, "offset");
  refused([](Options& o) { o.positionFilter = -2; }, "the position filter is -2 mm");
  refused([](Options& o) { o.chordTolerance = 0; }, "the chord tolerance is 0 mm");
  refused([](Options& o) { o.weldTolerance = kNan; }, "the weld tolerance is nan mm");
}

TEST(TrajectoryCheck, ChordsUpToACellAndWeldsUpToAHundredthOfTheBody) {
  Options options;
  EXPECT_EQ(chordTolerance(options, 5), 0.1);
  EXPECT_EQ(weldTolerance(options, 300), 3e-4);
  options.chordTolerance = 5;
  options.weldTolerance = 3;
  EXPECT_EQ(chordTolerance(options, 5), 5);
  EXPECT_EQ(weldTolerance(options, 300), 3);
  const auto text = [](const auto& call) -> std::string {
    try {
      call();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), "BadOption");
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(text([&] { chordTolerance(options, 4.5); }),
            "the chord tolerance is 5 mm; allowed: above 0 mm up to the size of a cell (4.5 mm)");
  EXPECT_EQ(text([&] { weldTolerance(options, 200); }),
            "the weld tolerance is 3 mm; allowed: 0 mm up to a hundredth of the diagonal of the "
            "part's bounding box (2 mm)");
}

TEST(TrajectoryCheck, bad_input_17_no_poses) { expectRefused({}, "EmptyTrajectory", "no poses"); }

TEST(TrajectoryCheck, bad_input_18_one_pose) {
  Trajectory trajectory = threePoses();
  trajectory.poses.resize(1);
  EXPECT_EQ(checkTrajectory(trajectory).trajectory.poses.size(), 1u);
}

TEST(TrajectoryCheck, bad_input_19_repeated_poses) {
  Trajectory trajectory = threePoses();
  for (int i = 0; i < 3; ++i) {
    Pose again = trajectory.poses.back();
    again.timeSeconds += 1;
    if (i == 1) again.rotation.coeffs() *= -1;  // the same rotation, other sign
    trajectory.poses.push_back(again);
  }
  const CheckedTrajectory checked = checkTrajectory(trajectory);
  EXPECT_EQ(checked.trajectory.poses.size(), 3u);
  ASSERT_EQ(checked.findings.size(), 1u);
  EXPECT_EQ(checked.findings[0].code, "RepeatedPoses");
  EXPECT_EQ(checked.findings[0].count, 3);
}

TEST(TrajectoryCheck, bad_input_20_small_drift_is_mended) {
  Trajectory trajectory = threePoses();
  trajectory.poses[1].rotation.coeffs() *= 1 + 5e-5;
  const CheckedTrajectory checked = checkTrajectory(trajectory);
  EXPECT_NEAR(checked.trajectory.poses[1].rotation.norm(), 1, 1e-15);
  ASSERT_EQ(checked.findings.size(), 1u);
  EXPECT_EQ(checked.findings[0].code, "RotationMended");
  EXPECT_EQ(checked.findings[0].first, std::vector<std::int64_t>{1});
}

TEST(TrajectoryCheck, bad_input_21_not_rigid) {
  Trajectory trajectory = threePoses();
  trajectory.poses[1].rotation.coeffs() *= 1.01;
  expectRefused(trajectory, "NotRigid", "pose 2");
  trajectory.poses[1].rotation.coeffs().setZero();
  expectRefused(trajectory, "NotRigid", "quaternion is zero");
}

TEST(TrajectoryCheck, EqualTimesKeepTheirOrder) {
  Trajectory trajectory = threePoses();
  trajectory.poses[2].timeSeconds = trajectory.poses[1].timeSeconds;
  const CheckedTrajectory checked = checkTrajectory(trajectory);
  ASSERT_EQ(checked.trajectory.poses.size(), 3u);
  EXPECT_EQ(checked.trajectory.poses[2].translation, trajectory.poses[2].translation);
  ASSERT_EQ(checked.findings.size(), 1u);
  EXPECT_EQ(checked.findings[0].code, "EqualTimes");
  EXPECT_EQ(checked.findings[0].first, std::vector<std::int64_t>{2});
}

TEST(TrajectoryCheck, bad_input_22_bad_pose) {
  Trajectory trajectory = threePoses();
  trajectory.poses[2].translation.y() = kNan;
  expectRefused(trajectory, "BadPose", "pose 3: the translation");
  trajectory = threePoses();
  trajectory.poses[1].rotation.x() = HUGE_VAL;
  expectRefused(trajectory, "BadPose", "pose 2: the rotation");
  trajectory = threePoses();
  trajectory.poses[0].timeSeconds = kNan;
  expectRefused(trajectory, "BadPose", "pose 1: the time");
  trajectory = threePoses();
  trajectory.poses[2].timeSeconds = trajectory.poses[1].timeSeconds - 0.5;
  expectRefused(trajectory, "BadPose", "pose 3: time 0.5 s is earlier than 1 s");
  trajectory = threePoses();
  trajectory.poses[1].translation.x() = -3e9;
  expectRefused(trajectory, "BadPose", "1e9 mm");
}

TEST(TrajectoryCheck, bad_input_23_ambiguous_turn) {
  Trajectory trajectory;
  trajectory.poses.push_back(poseOf(0, placement({0, 0, 1}, 10, {0, 0, 0})));
  trajectory.poses.push_back(poseOf(1, placement({0, 0, 1}, 189.5, {0, 0, 0})));
  expectRefused(trajectory, "AmbiguousTurn", "between pose 1 and pose 2");
  trajectory.interpolation = Interpolation::Screw;
  expectRefused(trajectory, "AmbiguousTurn", "179.5 degrees");
  trajectory.interpolation = Interpolation::None;  // nothing happens between the poses
  EXPECT_NO_THROW(checkTrajectory(trajectory));
  trajectory.interpolation = Interpolation::Linear;
  trajectory.poses[1] = poseOf(1, placement({0, 0, 1}, 188.5, {0, 0, 0}));
  EXPECT_NO_THROW(checkTrajectory(trajectory));
}

TEST(TrajectoryCheck, NeighboursHaveOneSign) {
  Trajectory trajectory = threePoses();
  trajectory.poses[1].rotation.coeffs() *= -1;
  const auto& poses = checkTrajectory(trajectory).trajectory.poses;
  EXPECT_GT(poses[0].rotation.dot(poses[1].rotation), 0);
  EXPECT_GT(poses[1].rotation.dot(poses[2].rotation), 0);
}

}  // namespace
}  // namespace swept::test
