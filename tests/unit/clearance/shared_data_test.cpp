// Clearance on real parts and a measured motion, against FCL at every pose.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <filesystem>

#include "support/shapes.h"
#include "swept/clearance.h"
#include "swept/io.h"

namespace swept {
namespace {

const std::string kData = SWEPT_SHARED_DATA;

TEST(ClearanceSharedData, VibratingBunnyAgreesWithStampingEveryPose) {
  const std::string mesh = kData + "/meshes/bunny_stanford_70k.ply";
  const std::string motion = kData + "/motions/vibration_sensor_193200.csv.xz";
  if (!std::filesystem::exists(mesh) || !std::filesystem::exists(motion)) {
    GTEST_SKIP() << "shared test data not found below " << kData;
  }
  const TriMesh bunny = readMesh(mesh, 1000.0);
  const Trajectory all = readTrajectoryCsv(motion, 1.0, Interpolation::None);
  Trajectory some{{}, Interpolation::None};
  for (std::size_t i = 0; i < all.poses.size(); i += 331) some.poses.push_back(all.poses[i]);
  double right = 0;
  for (const Eigen::Vector3d& v : bunny.vertices) right = std::max(right, v.x());
  TriMesh part = test::makeTorus(60, 8, 64, 32);
  for (Eigen::Vector3d& v : part.vertices) v += Eigen::Vector3d(right + 62, 90, 0);
  RunContext run;
  ClearanceOptions options;
  options.curveSamples = 0;
  const ClearanceReport report = checkClearance(bunny, some, {{"ring", part, 0}}, options, run);
  ASSERT_EQ(report.status, Status::Ok) << report.message;
  const StampedClearance stamped = stampedClearance(bunny, some, part, 0, run);
  EXPECT_EQ(stamped.poses, static_cast<std::int64_t>(some.poses.size()));
  EXPECT_NEAR(report.neighbours[0].distance, stamped.distance, 1e-7);
  EXPECT_EQ(report.neighbours[0].timeSeconds, stamped.timeSeconds);
  // Far fewer distances are measured than there are poses.
  EXPECT_LT(report.neighbours[0].distanceQueries, stamped.poses / 2);
}

}  // namespace
}  // namespace swept
