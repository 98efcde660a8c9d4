// The motion within a step: both ends, the positions between them, and that all functions give
// the same path.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "motion/step_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "clearance/motion_tree.h"
#include "motion/refine_motion.h"
#include "support/shapes.h"

namespace swept::test {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kRounding = 1e-11;  // mm, of bodies some 100 mm across

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double number(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  Vector3d point(double size) {
    return {number(-size, size), number(-size, size), number(-size, size)};
  }
  Isometry3d place() { return placement(point(1), number(0, 360), point(50)); }
  /// Returns a random angle of any size, sometimes 0.
  double degrees() { return number(0, 1) < 0.1 ? 0 : 179 * std::pow(10, number(-13, 0)); }

 private:
  std::mt19937 engine_;
};

Isometry3d asIsometry(const Pose& pose) {
  Isometry3d place = Isometry3d::Identity();
  place.linear() = pose.rotation.toRotationMatrix();
  place.translation() = pose.translation;
  return place;
}

double difference(const Isometry3d& a, const Isometry3d& b) {
  return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff();
}

/// Returns the permitted error (mm): rounding, and the effect of ignoring a turn below the smallest
/// screw angle.
double lossOf(const StepPath& path) {
  return kRounding + (path.angle() > 0 && path.angle() < 1e-3
                          ? 100 * std::min(path.angle(), 4e-16 / path.angle())
                          : 0);
}

TEST(StepPath, BeginsAndEndsAtItsPoses) {
  Random random(1);
  for (const Interpolation kind : {Interpolation::Linear, Interpolation::Screw}) {
    for (int n = 0; n < 2000; ++n) {
      const Isometry3d from = random.place();
      const Isometry3d to = placement(random.point(1), random.degrees(), random.point(20)) * from;
      const StepPath path(poseOf(2, from), poseOf(5, to), kind);
      EXPECT_LT(difference(asIsometry(path.poseAt(0)), from), lossOf(path));
      EXPECT_LT(difference(asIsometry(path.poseAt(1)), to), lossOf(path)) << path.angle();
      EXPECT_DOUBLE_EQ(path.poseAt(0.25).timeSeconds, 2.75);
    }
  }
}

TEST(StepPath, LinearIsSlerpAboutTheMovingOrigin) {
  Random random(2);
  for (int n = 0; n < 500; ++n) {
    const Pose from = poseOf(0, random.place()), to = poseOf(1, random.place());
    const StepPath path(from, to, Interpolation::Linear);
    const double s = random.number(0, 1);
    EXPECT_LT(path.poseAt(s).rotation.angularDistance(from.rotation.slerp(s, to.rotation)), 1e-7);
    const Vector3d chord = from.translation + s * (to.translation - from.translation);
    EXPECT_LT((path.poseAt(s).translation - chord).norm(), kRounding);
    EXPECT_FALSE(path.isScrew());
  }
}

/// A screw is a one-parameter group: the motion up to s and then the motion up to t give the motion
/// up to s + t. Together with both ends, this determines the motion.
TEST(StepPath, ScrewIsAOneParameterGroup) {
  Random random(3);
  for (int n = 0; n < 2000; ++n) {
    const Isometry3d from = random.place();
    const Isometry3d to = placement(random.point(1), random.degrees(), random.point(20)) * from;
    const StepPath path(poseOf(0, from), poseOf(1, to), Interpolation::Screw);
    const double s = random.number(0, 0.5), t = random.number(0, 0.5);
    const auto moved = [&](double at) { return asIsometry(path.poseAt(at)) * from.inverse(); };
    EXPECT_LT(difference(moved(s) * moved(t), moved(s + t)), lossOf(path)) << path.angle();
  }
}

TEST(StepPath, AxisOfAScrewOnlySlides) {
  Random random(4);
  for (int n = 0; n < 500; ++n) {
    const Isometry3d from = random.place();
    const Isometry3d to =
        placement(random.point(1), random.number(1, 179), random.point(20)) * from;
    const StepPath path(poseOf(0, from), poseOf(1, to), Interpolation::Screw);
    ASSERT_TRUE(path.isScrew());
    const double s = random.number(0, 1);
    const Isometry3d moved = asIsometry(path.poseAt(s)) * from.inverse();
    const Vector3d slid = path.axisPoint() + s * path.pitch() * path.axis();
    EXPECT_LT((moved * path.axisPoint() - slid).norm(), 1e-9);
    const Vector3d point = random.point(30);
    const Vector3d arm = from * point - path.axisPoint();
    EXPECT_NEAR(path.radius(point), arm.cross(path.axis()).norm(), 1e-9);
    const Sphere sphere{point, 2};
    EXPECT_LE(path.radius(point + 2 * random.point(1).normalized()), path.radius(sphere) + 1e-9);
  }
}

/// Just below and above the smallest angle of a screw, and far from it, the paths are the same,
/// up to the effect of the angle itself.
TEST(StepPath, NoJumpWhereAScrewBecomesAStraightLine) {
  Random random(5);
  for (int n = 0; n < 200; ++n) {
    const Isometry3d from = random.place();
    const Vector3d axis = random.point(1), shift = random.point(20);
    for (const double angle : {1e-10, 1e-9, 1e-8, 3.9e-8, 4.1e-8, 1e-7, 1e-6}) {
      const Isometry3d to = placement(axis, angle * 180 / M_PI, shift) * from;
      const Pose a = poseOf(0, from), b = poseOf(1, to);
      const Vector3d screw = StepPath(a, b, Interpolation::Screw).poseAt(0.5).translation;
      const Vector3d line = StepPath(a, b, Interpolation::Linear).poseAt(0.5).translation;
      EXPECT_LT((screw - line).norm(), angle * 40 + 1e-7 * 40 / 16) << angle;
    }
  }
}

/// The envelope and the distances to other parts use the same motion.
TEST(StepPath, SamplingAndClearanceMoveTheBodyAlike) {
  Random random(6);
  const TriMesh body = makeBox({-20, -10, -5}, {30, 20, 15});
  for (const Interpolation kind : {Interpolation::Linear, Interpolation::Screw}) {
    Trajectory trajectory{{}, kind};
    Isometry3d place = random.place();
    for (int i = 0; i < 200; ++i) {
      trajectory.poses.push_back(poseOf(i, place));
      place = placement(random.point(1), random.degrees(), random.point(20)) * place;
    }
    RunContext run;
    const Motion motion = refineMotion(body, trajectory, 0.1, run);
    const clearance::MotionTree tree(trajectory, {5, 5, 5}, {25, 15, 10});
    EXPECT_GT(motion.placements.size(), 2 * trajectory.poses.size());
    const auto expectSame = [&](const Placement& placed) {
      const Pose pose = tree.poseAt(placed.timeSeconds);
      for (const Vector3d& v : body.vertices) {
        EXPECT_LT((placed.apply(v) - pose.rotation * v - pose.translation).norm(), 1e-9)
            << placed.timeSeconds;
      }
    };
    for (const Placement& placed : motion.placements) expectSame(placed);
    for (const Placement& placed : motion.midpoints) expectSame(placed);
  }
}

/// The message gives poses as users count them, the angle, the radius and advice.
TEST(StepPath, AStepWithTooManyPiecesIsDescribed) {
  const TriMesh body = makeBox({-1, -1, -1}, {1, 1, 1});
  Trajectory trajectory{{}, Interpolation::Linear};
  trajectory.poses.push_back(poseOf(0, placement({0, 0, 1}, 0, {0, 0, 0})));
  trajectory.poses.push_back(poseOf(2, placement({0, 0, 1}, 90, {0, 0, 0})));
  RunContext run;
  try {
    refineMotion(body, trajectory, 1e-16, run);
    ADD_FAILURE() << "not refused";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), "ResourceLimit");
    const std::string text = error.what();
    for (const char* part : {"between poses 1 and 2 (counted from 1, at 0 s and 2 s)",
                             "turns by 90 degrees about an axis up to 1.732 mm away",
                             "more than 4000000 sampled placements; use a larger cell"})
      EXPECT_NE(text.find(part), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace swept::test
