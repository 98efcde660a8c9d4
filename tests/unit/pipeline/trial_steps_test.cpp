// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include "support/shapes.h"
#include "swept/compute.h"

namespace swept::test {
namespace {

// The box of a diagonal path is mostly empty: reckoned from it, these sweeps have 10 times as many
// triangles as they get.
TEST(TrialSteps, TheSurfaceIsGuessedFromTheSweepAndNotFromItsBox) {
  for (const int turns : {0, 3}) {
    Trajectory path;
    for (int n = 0; n <= 12; ++n) {
      Pose pose;
      pose.timeSeconds = n;
      pose.rotation = Eigen::AngleAxisd(0.5 * turns * n, Eigen::Vector3d::UnitZ());
      pose.translation = Eigen::Vector3d::Constant(4.0 * n);
      path.poses.push_back(pose);
    }
    const TriMesh body = makeBall({0, 0, 0}, 2, 3);
    Options options;
    options.resolution = 100;
    RunContext run;
    const double byBox = static_cast<double>(estimate(body, path, options).triangles);
    const double guessed = static_cast<double>(estimateByTrial(body, path, options, run).triangles);
    const Result result = compute(body, path, options, run);
    ASSERT_EQ(result.report.status, Status::Ok);
    const double made = static_cast<double>(result.mesh.triangles.size());
    EXPECT_GT(byBox / made, 6);
    EXPECT_GT(guessed / made, 0.5);
    EXPECT_LT(guessed / made, 3);
  }
}

}  // namespace
}  // namespace swept::test
