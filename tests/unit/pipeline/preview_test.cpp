// A preview session gives the same results as compute() with the same chord error, call after
// call.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "swept/preview.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "base/checkpoint_hook.h"
#include "support/random_case.h"
#include "support/shapes.h"

namespace swept::test {
namespace {

void expectSame(const Result& a, const Result& b) {
  ASSERT_EQ(a.report.status, Status::Ok) << a.report.message;
  ASSERT_EQ(b.report.status, Status::Ok) << b.report.message;
  EXPECT_TRUE(a.report.check.passes());
  EXPECT_EQ(a.mesh.vertices, b.mesh.vertices);
  EXPECT_EQ(a.mesh.triangles, b.mesh.triangles);
  EXPECT_EQ(a.contactTime, b.contactTime);
  EXPECT_EQ(a.featureEdges, b.featureEdges);
}

TEST(Preview, WhatIsKeptBetweenCallsDoesNotShowInTheResult) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1, 1);
  Options options;
  options.resolution = 40;
  for (const Interpolation kind : {Interpolation::Linear, Interpolation::Screw}) {
    const TriMesh body = randomBody(random);
    Trajectory motion;
    motion.interpolation = kind;
    for (int n = 0; n < 6; ++n) {
      motion.poses.push_back(
          poseOf(n, placement({1, 0.2 * n, 1}, 25.0 * n, {2.0 * n, 0, 0.3 * n})));
    }
    RunContext run;
    PreviewSession edited(body, options, run);
    const Result first = edited.compute(motion, run);
    for (int edit = 0; edit < 6; ++edit) {
      Trajectory next = motion;
      Pose& pose = next.poses[1 + static_cast<std::size_t>(edit % 4)];
      pose.translation += 0.1 * Eigen::Vector3d(unit(random), unit(random), unit(random));
      if (edit == 5) next.poses.erase(next.poses.begin() + 2);
      // The motion in reverse has the grid of the first motion, but none of its steps.
      Trajectory back = motion;
      std::reverse(back.poses.begin(), back.poses.end());
      for (std::size_t n = 0; n < back.poses.size(); ++n) {
        back.poses[n].timeSeconds = static_cast<double>(n);
      }
      PreviewSession fresh(body, options, run);
      fresh.compute(motion, run);
      fresh.compute(back, run);
      const std::int64_t before = edited.stepsKept();
      const Result a = edited.compute(next, run);
      EXPECT_GT(edited.stepsKept(), before);
      const Result b = fresh.compute(next, run);
      EXPECT_EQ(fresh.stepsKept(), 0);
      EXPECT_EQ(a.report.gridOrigin, b.report.gridOrigin);
      expectSame(a, b);
      Options full = options;
      full.cull = false;
      full.cellSize = a.report.cellSize;
      full.chordTolerance = kPreviewChord * *full.cellSize;
      const Result c = compute(body, next, full, run);
      EXPECT_NEAR(a.report.check.volume, c.report.check.volume,
                  0.1 * c.report.check.area * c.report.cellSize);
    }
    EXPECT_EQ(first.report.cellSize, edited.compute(motion, run).report.cellSize);
  }
}

TEST(Preview, AMotionThatLeavesTheGridGetsANewOne) {
  RunContext run;
  const TriMesh body = makeBall({0, 0, 0}, 1, 2);
  PreviewSession session(body, Options{}, run);
  Trajectory motion;
  motion.poses = {poseOf(0, placement({0, 0, 1}, 0, {0, 0, 0})),
                  poseOf(1, placement({0, 0, 1}, 10, {1, 0, 0}))};
  for (const double far : {5.0, 20.0, 2.0}) {
    motion.poses[1].translation.x() = far;
    const Result result = session.compute(motion, run);
    ASSERT_EQ(result.report.status, Status::Ok) << result.report.message;
    EXPECT_NEAR(result.report.check.volume, M_PI * (4.0 / 3 + far), 0.2 * (1 + far));
  }
}

TEST(Preview, FailuresAreThoseOfARun) {
  RunContext run;
  EXPECT_THROW(PreviewSession(TriMesh{}, Options{}, run), Error);
  Options options;
  options.resolution = 2;
  EXPECT_THROW(PreviewSession(makeBall({0, 0, 0}, 1, 2), options, run), Error);
  PreviewSession session(makeBall({0, 0, 0}, 1, 2), Options{}, run);
  EXPECT_EQ(session.compute(Trajectory{}, run).report.code, "EmptyTrajectory");
  Trajectory still;
  still.poses.push_back(Pose{});
  RunContext cancelled;
  CheckpointHook::cancelAt(cancelled, 3);
  EXPECT_EQ(session.compute(still, cancelled).report.status, Status::Cancelled);
  RunContext again;
  EXPECT_EQ(session.compute(still, again).report.status, Status::Ok);
}

TEST(Preview, ASketchIsTheSurfaceBeforeItIsMendedAndChecked) {
  RunContext run;
  Options options;
  options.resolution = 32;
  Trajectory motion;
  motion.poses = {poseOf(0, placement({0, 0, 1}, 0, {0, 0, 0})),
                  poseOf(1, placement({0, 0, 1}, 40, {3, 1, 0}))};
  PreviewSession session(makeBall({0, 0, 0}, 1, 2), options, run);
  const Result whole = session.compute(motion, run), sketch = session.sketch(motion, run);
  ASSERT_EQ(sketch.report.status, Status::Ok) << sketch.report.message;
  const auto has = [](const Result& result, const char* code) {
    return std::any_of(result.report.warnings.begin(), result.report.warnings.end(),
                       [&](const Finding& f) { return f.code == code; });
  };
  EXPECT_TRUE(has(sketch, "NotChecked"));
  EXPECT_FALSE(has(whole, "NotChecked"));
  ASSERT_FALSE(has(whole, "Mended")) << "another case is needed: here nothing is to be mended";
  EXPECT_EQ(sketch.mesh.vertices, whole.mesh.vertices);
  EXPECT_EQ(sketch.mesh.triangles, whole.mesh.triangles);
  EXPECT_FALSE(sketch.report.check.passes());
}

TEST(Preview, AConservativeEnvelopeIsNotSketched) {
  RunContext run;
  Options options;
  options.conservative = true;
  PreviewSession session(makeBall({0, 0, 0}, 1, 2), options, run);
  const Report refused = session.sketch(Trajectory{}, run).report;
  EXPECT_EQ(refused.status, Status::InvalidInput);
  EXPECT_EQ(refused.code, "BadOption");
}

}  // namespace
}  // namespace swept::test
