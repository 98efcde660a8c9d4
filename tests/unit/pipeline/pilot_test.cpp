// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include "support/shapes.h"
#include "swept/compute.h"

namespace swept::test {
namespace {

Trajectory shiftAndTurn() {
  Trajectory path;
  for (int n = 0; n < 3; ++n) {
    Pose pose;
    pose.timeSeconds = n;
    pose.rotation = Eigen::AngleAxisd(0.3 * n, Eigen::Vector3d::UnitZ());
    pose.translation = {0.7 * n, 0.2 * n * n, 0};
    path.poses.push_back(pose);
  }
  return path;
}

// The estimate from the bounding box of the sweep alone would refuse this run; the count on a
// coarse grid does not.
TEST(Pilot, TellsWhatFitsAfterAll) {
  const TriMesh body = makeBall({0, 0, 0}, 2, 3);
  Options options;
  options.resolution = 560;
  const std::uint64_t rough = estimate(body, shiftAndTurn(), options).memoryBytes;
  RunContext run;
  run.memoryLimitBytes = rough / 5 * 4;
  const Result result = compute(body, shiftAndTurn(), options, run);
  ASSERT_EQ(result.report.status, Status::Ok) << result.report.message;
  EXPECT_LE(result.report.estimatedMemoryBytes, *run.memoryLimitBytes);
  // The estimate is plausible: at least the bytes that each crossing takes, and not far more.
  const double each = static_cast<double>(result.report.estimatedMemoryBytes) /
                      static_cast<double>(result.report.crossings);
  EXPECT_GT(each, 320);
  EXPECT_LT(each, 500);
}

TEST(Pilot, WhatDoesNotFitIsRefused) {
  Options options;
  options.resolution = 2000;
  RunContext run;
  run.memoryLimitBytes = 300 << 20;
  const Result result = compute(makeBall({0, 0, 0}, 2, 3), shiftAndTurn(), options, run);
  EXPECT_EQ(result.report.status, Status::ResourceLimit);
  EXPECT_EQ(result.report.code, "ResourceLimit");
  EXPECT_TRUE(result.mesh.triangles.empty());
}

}  // namespace
}  // namespace swept::test
