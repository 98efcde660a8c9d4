// Improved motions: they are proven clear, never have less clearance than requested, and are the
// same for any number of threads. Also: live clearance.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include "base/checkpoint_hook.h"
#include "support/path_cases.h"
#include "support/path_check.h"
#include "support/shapes.h"
#include "swept/live_clearance.h"

namespace swept {
namespace {

using namespace test;

// Returns the straight motion from start to goal in equal moves, through all neighbours.
Trajectory straightMotion(const PathCase& c, int moves) {
  Trajectory motion;
  motion.interpolation = Interpolation::Linear;
  for (int i = 0; i <= moves; ++i) {
    const double fraction = static_cast<double>(i) / moves;
    Pose pose;
    pose.timeSeconds = 2 * fraction;
    pose.translation = (1 - fraction) * c.start.translation + fraction * c.goal.translation;
    pose.rotation = c.start.rotation.slerp(fraction, c.goal.rotation);
    motion.poses.push_back(pose);
  }
  return motion;
}

PathReport improve(const PathCase& c, const ImproveTask& task, const PathOptions& options,
                   int threads = 1) {
  RunContext run;
  run.threads = threads;
  return improvePath(c.part, task, neighboursOf(c), options, run);
}

// Returns whether the ordinary clearance check finds the whole motion clear.
bool isClear(const PathCase& c, const Trajectory& motion, double required) {
  RunContext run;
  ClearanceOptions options;
  options.required = required;
  const ClearanceReport report = checkClearance(c.part, motion, neighboursOf(c), options, run);
  EXPECT_EQ(report.status, Status::Ok) << report.message;
  for (const NeighbourClearance& row : report.neighbours)
    if (row.verdict != ClearanceVerdict::Clear) return false;
  return true;
}

TEST(ImprovePath, ClashesAreLedRoundAndTheWholeMotionIsClear) {
  int clashed = 0;
  for (unsigned seed = 0; seed < 12; ++seed) {
    const PathCase c = seed % 2 ? cornerCase(seed) : channelCase(seed);
    const ImproveTask task{straightMotion(c, 5), {}, false};
    clashed += isClear(c, task.motion, c.clearance) ? 0 : 1;
    const PathReport report = improve(c, task, patient(c));
    ASSERT_EQ(report.status, Status::Ok) << report.message;
    ASSERT_EQ(report.verdict, PathVerdict::Found) << c.name << ' ' << seed;
    ASSERT_EQ(report.unmendedMoves, 0) << c.name << ' ' << seed << report.summary;
    EXPECT_TRUE(isClear(c, report.path, c.clearance)) << c.name << ' ' << seed;
    EXPECT_EQ(report.path.poses.front().translation, c.start.translation);
    EXPECT_EQ(report.path.poses.back().translation, c.goal.translation);
    EXPECT_EQ(report.path.poses.back().timeSeconds, 2);
  }
  EXPECT_GT(clashed, 3);
}

TEST(ImprovePath, AFoundPathStaysClearWithMoreClearanceAndLockedKeys) {
  for (unsigned seed = 0; seed < 4; ++seed) {
    const PathCase c = cornerCase(seed);
    RunContext run;
    const PathReport found = findPath(c.part, taskOf(c), neighboursOf(c), patient(c), run);
    ASSERT_EQ(found.verdict, PathVerdict::Found);
    ImproveTask task{found.path, {found.path.poses.size() / 2}, true};
    PathOptions options = patient(c);
    options.budgetSeconds = 2;
    const PathReport report = improve(c, task, options);
    ASSERT_EQ(report.verdict, PathVerdict::Found) << report.message;
    EXPECT_GE(report.clearance, c.clearance);
    EXPECT_TRUE(isClear(c, report.path, report.clearance - 1e-9)) << seed;
    const Pose& locked = found.path.poses[task.locked[0]];
    int kept = 0;
    for (const Pose& pose : report.path.poses)
      kept += pose.translation == locked.translation && pose.timeSeconds == locked.timeSeconds;
    EXPECT_EQ(kept, 1) << seed;
  }
}

TEST(ImprovePath, TheSameKeysForAnyCountOfThreads) {
  const PathCase c = cornerCase(1);
  const ImproveTask task{straightMotion(c, 4), {}, false};
  const PathReport one = improve(c, task, patient(c));
  for (const int threads : {2, 3}) {
    const PathReport other = improve(c, task, patient(c), threads);
    ASSERT_EQ(other.path.poses.size(), one.path.poses.size());
    for (std::size_t i = 0; i < one.path.poses.size(); ++i)
      EXPECT_EQ(other.path.poses[i].translation, one.path.poses[i].translation);
  }
}

TEST(ImprovePath, APivotMeansTheSameMotion) {
  const PathCase c = cornerCase(3);
  ImproveTask task{straightMotion(c, 4), {}, false};
  task.motion.pivot = {7, -3, 2};
  const PathReport report = improve(c, task, patient(c));
  ASSERT_EQ(report.verdict, PathVerdict::Found) << report.message;
  EXPECT_EQ(report.path.pivot, task.motion.pivot);
  EXPECT_EQ(report.unmendedMoves, 0);
  EXPECT_TRUE(isClear(c, report.path, c.clearance - 1e-7));
}

TEST(ImprovePath, BadInputIsNamedAndCancelEnds) {
  const PathCase c = cornerCase(0);
  const Trajectory motion = straightMotion(c, 3);
  const auto codeOf = [&](const ImproveTask& task) { return improve(c, task, patient(c)).code; };
  EXPECT_EQ(codeOf({motion, {4}, false}), "BadOption");
  EXPECT_EQ(codeOf({Trajectory{{motion.poses[0]}, motion.interpolation}, {}, false}), "BadPose");
  EXPECT_EQ(codeOf({Trajectory{motion.poses, Interpolation::None}, {}, false}), "BadOption");
  Trajectory back = motion;
  back.poses[1].timeSeconds = -1;
  EXPECT_EQ(codeOf({back, {}, false}), "BadPose");
  RunContext run;
  CheckpointHook::cancelAt(run, 3);
  const PathReport report =
      improvePath(c.part, {motion, {}, true}, neighboursOf(c), patient(c), run);
  EXPECT_EQ(report.status, Status::Cancelled);
  EXPECT_TRUE(report.path.poses.empty());
}

TEST(LiveClearance, AgreesWithTheExactCheckAtEveryPlacement) {
  int clashes = 0, apart = 0;
  for (unsigned seed = 0; seed < 3; ++seed) {
    const PathCase c = scatteredCase(seed);
    RunContext run;
    LiveClearance live(c.part, neighboursOf(c), run);
    const Trajectory motion = straightMotion(c, 25);
    for (const Pose& pose : motion.poses) {
      const LiveDistance found = live.at(pose);
      ClearanceOptions options;
      options.penetration = false;
      Trajectory still{{pose}, Interpolation::None};
      const ClearanceReport report = checkClearance(c.part, still, neighboursOf(c), options, run);
      const NeighbourClearance& row = report.neighbours[report.smallest.value()];
      EXPECT_NEAR(found.distance, row.distance, 1e-9);
      (row.distance > 0 ? apart : clashes) += 1;
      if (row.distance > 0) {
        EXPECT_NEAR((found.pointOnPart - found.pointOnNeighbour).norm(), found.distance, 1e-6);
      }
      const Pose reached = live.reached(motion.poses.front(), pose, 0.2);
      if (live.at(motion.poses.front()).distance > 0.2) {
        EXPECT_GE(live.at(reached).distance, 0.2 - 1e-7);
      }
    }
  }
  EXPECT_GT(apart, 10);
  EXPECT_GT(clashes + apart, 70);
}

}  // namespace
}  // namespace swept
