// Points inside and outside of the volume that a box sweeps, against samples of the motion.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/swept_interior.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "motion/pivot.h"
#include "solid/test_meshes.h"

namespace swept {
namespace {

using Eigen::Vector3d;

constexpr double kAccuracy = 1e-3;

// Returns the smallest distance, negative inside, of the point from the box [0, 12] x [0, 8] x
// [0, 5] at many moments of the motion.
double depthOf(const Vector3d& point, const Trajectory& trajectory) {
  constexpr int kMoments = 4000;
  const Vector3d half(6, 4, 2.5);
  const Trajectory carried = carriedByPivot(trajectory, pivotOf(trajectory));
  double smallest = HUGE_VAL;
  for (std::size_t k = 0; k + 1 < carried.poses.size(); ++k) {
    const StepPath path(carried.poses[k], carried.poses[k + 1], carried.interpolation);
    for (int i = 0; i <= kMoments; ++i) {
      const Placement at = path.at(static_cast<double>(i) / kMoments);
      const Vector3d seen =
          at.rotation.transpose() * (point - at.translation) + pivotOf(trajectory) - half;
      smallest = std::min(smallest, (seen.cwiseAbs() - half).maxCoeff());
    }
  }
  return smallest;
}

void expectAgreement(const Trajectory& trajectory, const Vector3d& low, const Vector3d& high) {
  const step::SweptInterior interior(test::boxMesh(12, 8, 5), trajectory, kAccuracy);
  std::mt19937 random(7);
  int inside = 0, outside = 0;
  for (int i = 0; i < 800; ++i) {
    Vector3d point;
    for (int axis = 0; axis < 3; ++axis) {
      const double part = static_cast<double>(random()) / 4294967296.0;
      point[axis] = low[axis] + part * (high[axis] - low[axis]);
    }
    const double depth = depthOf(point, trajectory);
    if (std::abs(depth) < 0.02) continue;  // the samples of the motion cannot tell
    EXPECT_EQ(interior.contains(point), depth < 0) << point.transpose() << ", depth " << depth;
    ++(depth < 0 ? inside : outside);
  }
  EXPECT_GT(inside, 30);
  EXPECT_GT(outside, 50);
}

Trajectory motionTo(const Vector3d& shift, const Eigen::Quaterniond& turn) {
  Trajectory trajectory;
  trajectory.poses.resize(2);
  trajectory.poses[1].timeSeconds = 1;
  trajectory.poses[1].translation = shift;
  trajectory.poses[1].rotation = turn;
  return trajectory;
}

TEST(SweptInterior, StraightMove) {
  expectAgreement(motionTo({7, 14, 9}, Eigen::Quaterniond::Identity()), {-3, -3, -3}, {22, 25, 17});
}

TEST(SweptInterior, TurnAndMoveAboutAPivot) {
  Trajectory trajectory = motionTo(
      {7, 14, 9}, Eigen::Quaterniond(Eigen::AngleAxisd(1.2, Vector3d(1, 2, 3).normalized())));
  trajectory.pivot = {-9, 3, 2};
  expectAgreement(trajectory, {-6, -4, -6}, {16, 20, 16});
}

// Checks points near the paths of three corners. `clear`: mm, nearer to the surface they are left
// out.
void expectAgreementNearCorners(const Trajectory& trajectory, double accuracy, double clear,
                                const std::vector<Vector3d>& offsets) {
  const step::SweptInterior interior(test::boxMesh(12, 8, 5), trajectory, accuracy);
  const StepPath path(trajectory.poses[0], trajectory.poses[1], trajectory.interpolation);
  int inside = 0, outside = 0;
  for (int i = 1; i < 200; ++i) {
    const double s = i / 200.0;
    for (const Vector3d& corner : {Vector3d(12, 8, 2), Vector3d(0, 0, 2), Vector3d(12, 0, 2)}) {
      for (const Vector3d& offset : offsets) {
        const Vector3d point = path.at(s).apply(corner) + offset;
        const double depth = depthOf(point, trajectory);
        if (std::abs(depth) < clear) continue;
        EXPECT_EQ(interior.contains(point), depth < 0) << point.transpose() << ", depth " << depth;
        ++(depth < 0 ? inside : outside);
      }
    }
  }
  EXPECT_GT(inside, 100);
  EXPECT_GT(outside, 100);
}

// Seen from a body that turns while it moves, points move on curves that bend more than their
// distances from the body's origin tell.
TEST(SweptInterior, PointsNearTheSurfaceOfALongMove) {
  expectAgreementNearCorners(
      motionTo({40, 0, 0}, Eigen::Quaterniond(Eigen::AngleAxisd(0.1, Vector3d::UnitZ()))), 5e-3,
      0.02, {{0, -0.05, 0}, {0, 0.05, 0}});
}

TEST(SweptInterior, PointsNearTheSurfaceOfAShortMove) {
  constexpr double kOff = 0.02;
  expectAgreementNearCorners(
      motionTo({0.9, 0, 0}, Eigen::Quaterniond(Eigen::AngleAxisd(0.1, Vector3d::UnitZ()))), 0.012,
      0.015, {{-kOff, -kOff, 0}, {-kOff, kOff, 0}, {kOff, -kOff, 0}, {kOff, kOff, 0}});
}

TEST(SweptInterior, PointsThatStayInTheBody) {
  const step::SweptInterior interior(
      test::boxMesh(12, 8, 5), motionTo({0.1, 0, 0}, Eigen::Quaterniond::Identity()), kAccuracy);
  EXPECT_TRUE(interior.contains({6, 4, 2.5}));
  EXPECT_FALSE(interior.contains({6, 4, 5.01}));
}

}  // namespace
}  // namespace swept
