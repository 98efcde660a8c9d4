// Clearance over motions whose smallest distance, time and depth are known in closed form.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "swept/clearance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/checkpoint_hook.h"
#include "clearance/pair_search.h"
#include "clearance/stamping.h"
#include "clearance/summary.h"
#include "support/sampled.h"
#include "support/shapes.h"

namespace swept {
namespace {

using Eigen::Vector3d;
using namespace swept::test;

constexpr double kDegree = 3.14159265358979323846 / 180;

Pose shifted(double time, const Vector3d& by) { return poseOf(time, placement({0, 0, 1}, 0, by)); }
Pose turned(double time, double degrees) {
  return poseOf(time, placement({0, 0, 1}, degrees, Vector3d::Zero()));
}
Trajectory motionOf(std::vector<Pose> poses, Interpolation kind = Interpolation::Linear) {
  return {std::move(poses), kind};
}

NeighbourClearance checkOne(const TriMesh& body, const Trajectory& motion, const TriMesh& part,
                            const ClearanceOptions& options = {}, double chord = 0) {
  RunContext run;
  const ClearanceReport report =
      checkClearance(body, motion, {{"part", part, chord}}, options, run);
  EXPECT_EQ(report.status, Status::Ok) << report.message;
  if (report.neighbours.empty()) return {};
  return report.neighbours[0];
}

// Returns how deep the triangles of a ball lie inside its sphere.
double chordOf(const TriMesh& ball, const Vector3d& centre, double radius) {
  double worst = 0;
  for (const auto& t : ball.triangles) {
    const Vector3d a = ball.vertices[t[0]];
    const Vector3d n = (ball.vertices[t[1]] - a).cross(ball.vertices[t[2]] - a).normalized();
    worst = std::max(worst, radius - std::abs(n.dot(a - centre)));
  }
  return worst;
}

TEST(Clearance, BallPastBall) {
  const TriMesh body = makeBall(Vector3d::Zero(), 10, 4);
  const TriMesh part = makeBall({0, 0, 0}, 5, 4);
  ClearanceOptions options;
  options.required = 12;
  options.bodyChordError = chordOf(body, Vector3d::Zero(), 10);
  const double partChord = chordOf(part, Vector3d::Zero(), 5);
  const double chord = options.bodyChordError + partChord;
  ASSERT_LT(chord, 0.05);
  const Trajectory motion = motionOf({shifted(0, {-100, 25, 0}), shifted(1, {170, 25, 0})});
  const NeighbourClearance row = checkOne(body, motion, part, options, partChord);
  EXPECT_LE(row.guaranteed, 10);
  EXPECT_GE(row.distance, 10 - 1e-9);
  EXPECT_LE(row.distance, 10 + chord + 1e-9);
  const auto exact = [](double t) { return std::hypot(-100 + 270 * t, 25) - 15; };
  EXPECT_LE(exact(row.timeSeconds), 10 + chord);  // the balls are really that near
  EXPECT_EQ(row.verdict, ClearanceVerdict::BelowRequired);
  ASSERT_EQ(row.below.size(), 1u);
  const double reach = std::sqrt(27 * 27 - 25 * 25);  // centres 27 apart: 12 mm between the balls
  const double from = (100 - reach) / 270;
  const double to = (100 + reach) / 270;
  EXPECT_LE(row.below[0].from, from + 1e-9);
  EXPECT_GE(row.below[0].to, to - 1e-9);
  // The interval may be too long by the resolution of 0.1 mm, and by the travel that corresponds
  // to twice the mesh deflection.
  const double slack = (0.2 + 2 * chord * 27 / reach) / 270;
  EXPECT_GE(row.below[0].from, from - slack);
  EXPECT_LE(row.below[0].to, to + slack);
}

TEST(Clearance, ABodyThatWaitsIsNearForAsLong) {
  const TriMesh body = makeBox({-5, -5, -5}, {5, 5, 5}),
                wall = makeBox({-50, 11, -50}, {50, 15, 50});
  ClearanceOptions options;
  options.required = 7.5;
  // The body comes 9 mm nearer in a second, waits there for five seconds, and moves back.
  for (const std::vector<double>& waiting : {std::vector<double>{1, 6}, {1, 2, 3.5, 4, 6}}) {
    std::vector<Pose> poses{shifted(0, {0, -10, 0})};
    for (const double time : waiting) poses.push_back(shifted(time, {0, -1, 0}));
    poses.push_back(shifted(7, {0, -10, 0}));
    const NeighbourClearance row = checkOne(body, motionOf(poses), wall, options);
    EXPECT_NEAR(row.distance, 7, 1e-9);
    EXPECT_GE(row.timeSeconds, 1 - 1e-9);
    EXPECT_LE(row.timeSeconds, 6 + 1e-9);
    const double slack = 10 * options.tolerance / 9;  // intervals end within ten tolerances
    ASSERT_EQ(row.below.size(), 1u);
    EXPECT_NEAR(row.below[0].from, 1 - 0.5 / 9, slack);
    EXPECT_NEAR(row.below[0].to, 6 + 0.5 / 9, slack);
    for (const auto& [time, distance] : row.curve) {
      const double aside = std::max({0.0, 1 - time, time - 6});
      EXPECT_NEAR(distance, 7 + 9 * aside, options.tolerance) << time;
    }
  }
}

TEST(Clearance, BoxPastBox) {
  const TriMesh box = makeBox(Vector3d::Constant(-5), Vector3d::Constant(5));
  const Trajectory motion = motionOf({shifted(0, {0, 40, 0}), shifted(1, {50, -10, 0})});
  const NeighbourClearance row = checkOne(box, motion, box);
  EXPECT_NEAR(row.distance, std::sqrt(200.0), 1e-9);
  EXPECT_NEAR(row.timeSeconds, 0.4, 1e-6);
  EXPECT_EQ(row.verdict, ClearanceVerdict::Clear);
  EXPECT_NEAR((row.pointOnBody - row.pointOnNeighbour).norm(), row.distance, 1e-9);
  EXPECT_NEAR(row.pointOnNeighbour.x(), 5, 1e-9);
  EXPECT_NEAR(row.pointOnNeighbour.y(), 5, 1e-9);
}

// A bar that turns about z, and a post whose vertical edge points at the axis, at the distance
// `radius` and an angle of 50 degrees.
struct TurningBar {
  TriMesh bar = makeBox({0, -5, -5}, {100, 3, 5});
  double corner = std::hypot(100.0, 5.0);
  double time = (50 + std::atan2(5.0, 100.0) / kDegree) / 90;
  Trajectory motion(Interpolation kind) const {
    return motionOf({turned(0, 0), turned(1, 90)}, kind);
  }
  TriMesh post(double radius) const {
    const double angle = 50 * kDegree;
    return transformed(
        makeBox({0, 0, -20}, {6, 6, 20}),
        placement({0, 0, 1}, 5, radius * Vector3d(std::cos(angle), std::sin(angle), 0)));
  }
};

TEST(Clearance, TurningBarPastAPost) {
  const TurningBar c;
  for (const Interpolation kind : {Interpolation::Linear, Interpolation::Screw}) {
    const NeighbourClearance row = checkOne(c.bar, c.motion(kind), c.post(110));
    EXPECT_NEAR(row.distance, 110 - c.corner, 1e-9);
    EXPECT_NEAR(row.timeSeconds, c.time, 1e-6);  // between the two keys
    EXPECT_EQ(row.verdict, ClearanceVerdict::Clear);
  }
}

TEST(Clearance, TurningBarTouchesThePost) {
  const TurningBar c;
  ClearanceOptions options;
  options.tolerance = 0.001;
  const NeighbourClearance row =
      checkOne(c.bar, c.motion(Interpolation::Linear), c.post(c.corner), options);
  EXPECT_LE(row.distance, options.tolerance);
  EXPECT_EQ(row.verdict, ClearanceVerdict::Contact);
  // The end face of the bar leaves the post at 5 mm per radian: after a turn of 0.01 degrees, the
  // gap is nearly 0.001 mm.
  EXPECT_NEAR(row.timeSeconds, c.time, 0.01);
  ASSERT_EQ(row.contact.size(), 1u);
  EXPECT_LE(row.contact[0].from, c.time);
  EXPECT_GE(row.contact[0].to, c.time);
}

TEST(Clearance, TurningBarRunsIntoThePost) {
  const TurningBar c;
  const NeighbourClearance row = checkOne(c.bar, c.motion(Interpolation::Linear), c.post(99));
  EXPECT_EQ(row.distance, 0);
  EXPECT_EQ(row.verdict, ClearanceVerdict::Clash);
  ASSERT_TRUE(row.penetration.known);
  // The edge of the post is deepest inside the bar when it is equally far from the end and the
  // side of the bar.
  double low = 0;
  double high = 5 / 99.0;
  for (int i = 0; i < 100; ++i) {
    const double angle = 0.5 * (low + high);
    (100 - 99 * std::cos(angle) < 5 - 99 * std::sin(angle) ? low : high) = angle;
  }
  const double depth = 100 - 99 * std::cos(low);
  EXPECT_LE(row.penetration.depth, depth + 1e-9);
  EXPECT_GE(row.penetration.depthBound, depth - 1e-9);
  EXPECT_GE(row.penetration.depth, depth - std::max(0.01, 0.011 * depth));
  EXPECT_FALSE(row.penetration.pointOfBody);
  for (int k = 0; k < 3; ++k) {
    EXPECT_LE(row.penetration.regionMin[k], row.penetration.point[k]);
    EXPECT_GE(row.penetration.regionMax[k], row.penetration.point[k]);
  }
  ASSERT_EQ(row.contact.size(), 1u);
  EXPECT_LE(row.contact[0].from, row.timeSeconds);
  EXPECT_GE(row.contact[0].to, row.timeSeconds);
}

TEST(Clearance, DepthAndRegionOfABoxPushedIntoABlock) {
  const TriMesh box = makeBox(Vector3d::Constant(-1), Vector3d::Constant(1));
  const TriMesh block = makeBox({10, -20, -20}, {50, 20, 20});
  // Forwards and back: the face x = 1 reaches x = 12.5 at t = 1.
  const Trajectory motion =
      motionOf({shifted(0, {0, 0, 0}), shifted(1, {11.5, 0.3, 0}), shifted(3, {0, 0, 0})});
  const NeighbourClearance row = checkOne(box, motion, block);
  EXPECT_EQ(row.verdict, ClearanceVerdict::Clash);
  EXPECT_LE(row.penetration.depth, 2.5 + 1e-9);
  EXPECT_GE(row.penetration.depth, 2.5 - 0.026);
  EXPECT_NEAR(row.timeSeconds, 1, 0.01);
  const Vector3d low = row.penetration.regionMin;
  const Vector3d high = row.penetration.regionMax;
  EXPECT_NEAR(low.x(), 10, 1e-6);
  EXPECT_NEAR(high.x(), 12.5, 0.03);
  EXPECT_NEAR(high.y() - low.y(), 2, 1e-6);
  EXPECT_NEAR(high.z() - low.z(), 2, 1e-6);
  ASSERT_EQ(row.contact.size(), 1u);
  EXPECT_NEAR(row.contact[0].from, 9 / 11.5, 0.03);
  EXPECT_NEAR(row.contact[0].to, 1 + 2 * 2.5 / 11.5, 0.03);
}

TEST(Clearance, SlidingOnAFaceIsContactNotClash) {
  const TriMesh box = makeBox(Vector3d::Zero(), Vector3d::Constant(4));
  const TriMesh table = makeBox({-50, -50, -10}, {50, 50, 0});
  const Trajectory motion = motionOf({shifted(0, {-30, 3, 0}), shifted(1, {20, 5, 0})});
  const NeighbourClearance row = checkOne(box, motion, table);
  EXPECT_EQ(row.distance, 0);
  EXPECT_EQ(row.verdict, ClearanceVerdict::Contact);
}

TEST(Clearance, SlidingAtAConstantGapIsCheap) {
  TriMesh body = makeBall({0, 0, 0}, 10, 4);
  const TriMesh wall = makeBox({-2000, -50, -30}, {2000, 50, -10.5});
  const Trajectory motion = motionOf({shifted(0, {-1500, 0, 0}), shifted(1, {1500, 0, 0})});
  const NeighbourClearance row = checkOne(body, motion, wall);
  double lowest = 0;
  for (const Vector3d& v : body.vertices) lowest = std::min(lowest, v.z());
  EXPECT_NEAR(row.distance, 10.5 + lowest, 1e-9);
  // With steps as small as the accuracy, 150,000 proofs would be needed.
  EXPECT_LT(row.certificates, 2000);
}

TEST(Clearance, ContactOfAThousandthOfAKeyInterval) {
  const TriMesh body = makeBox({-2, -2, -2}, {2, 2, 2});
  const TriMesh post = makeBox({-1, -30, -30}, {1, 30, 30});
  // In one step of 6000 mm, the bodies are in contact for 6 mm of travel, at 61.7 % of the step.
  const Trajectory motion = motionOf({shifted(0, {-3702, 0, 0}), shifted(1, {2298, 0, 0})});
  const NeighbourClearance row = checkOne(body, motion, post);
  EXPECT_EQ(row.verdict, ClearanceVerdict::Clash);
  EXPECT_NEAR(row.timeSeconds, 0.617, 0.0006);
  ASSERT_EQ(row.contact.size(), 1u);
  EXPECT_NEAR(row.contact[0].to - row.contact[0].from, 0.001, 0.0001);
  EXPECT_NEAR(row.contact[0].from, 0.6165, 0.0001);
  EXPECT_NEAR(row.penetration.depth, 2,
              0.021);  // a face of the post lies in the middle of the body
}

TEST(Clearance, GrazingForAThousandthIsFoundToo) {
  const TurningBar c;
  // The corner reaches 0.003 mm beyond the post's edge, for 0.04 of the 260 degrees of the motion.
  Trajectory motion = motionOf({turned(0, -60), turned(1, 60), turned(2, 120), turned(3, 200)});
  ClearanceOptions options;
  options.tolerance = 0.0005;
  const NeighbourClearance row = checkOne(c.bar, motion, c.post(c.corner - 0.003), options);
  EXPECT_EQ(row.verdict, ClearanceVerdict::Clash);
  EXPECT_LT(row.penetration.depth, 0.005);
}

TEST(Clearance, SmallPartInsideABigOne) {
  const TriMesh small = makeBox(Vector3d::Constant(-1), Vector3d::Constant(1));
  const TriMesh big = makeBox(Vector3d::Constant(-20), Vector3d::Constant(20));
  const Trajectory motion = motionOf({shifted(0, {-5, 0, 0}), shifted(1, {5, 0, 0})});
  for (const bool swap : {false, true}) {
    const NeighbourClearance row =
        swap ? checkOne(big, motion, small) : checkOne(small, motion, big);
    EXPECT_TRUE(row.inside);
    EXPECT_EQ(row.verdict, ClearanceVerdict::Clash);
    // At half time, the faces x = 1 and x = -1 are 19 and 21 mm inside the face x = 20.
    EXPECT_LE(row.penetration.depth, 21);
    EXPECT_GE(row.penetration.depth, 19 - 0.2);
    ASSERT_EQ(row.contact.size(), 1u);
    EXPECT_EQ(row.contact[0].from, 0);
    EXPECT_EQ(row.contact[0].to, 1);
    ASSERT_FALSE(row.curve.empty());
    for (const CurvePoint& point : row.curve) EXPECT_EQ(point.distance, 0) << point.timeSeconds;
  }
}

// The middles of the balls are 1 mm apart at first, and 2 mm at the end. So nearly all triangles
// are equally near.
TEST(Clearance, BallInTheMiddleOfABall) {
  const TriMesh small = makeBall(Vector3d::Zero(), 3, 3), big = makeBall(Vector3d::Zero(), 10, 4);
  const Trajectory motion = motionOf({shifted(0, {1, 0, 0}), shifted(1, {2, 0, 0})});
  for (const bool swap : {false, true}) {
    const NeighbourClearance row =
        swap ? checkOne(big, motion, small) : checkOne(small, motion, big);
    EXPECT_TRUE(row.inside);
    EXPECT_EQ(row.verdict, ClearanceVerdict::Clash);
    // The surface of the small ball comes within 3 - 2 = 1 mm of the middle of the large one.
    EXPECT_LE(row.penetration.depth, 9);
    EXPECT_GE(row.penetration.depthBound, 9 - chordOf(big, Vector3d::Zero(), 10) - 0.05);
    EXPECT_GE(row.penetration.depth, 0.99 * row.penetration.depthBound - 0.01);
    for (const CurvePoint& point : row.curve) EXPECT_EQ(point.distance, 0) << point.timeSeconds;
  }
}

TEST(Clearance, PartInASealedHollowIsClear) {
  TriMesh hollow = makeBox(Vector3d::Constant(-20), Vector3d::Constant(20));
  append(hollow, inverted(makeBox(Vector3d::Constant(-15), Vector3d::Constant(15))));
  const TriMesh small = makeBox(Vector3d::Constant(-1), Vector3d::Constant(1));
  const Trajectory motion = motionOf({shifted(0, {-5, 0, 0}), shifted(1, {5, 0, 0})});
  const NeighbourClearance row = checkOne(small, motion, hollow);
  EXPECT_FALSE(row.inside);
  EXPECT_EQ(row.verdict, ClearanceVerdict::Clear);
  EXPECT_NEAR(row.distance, 9, 1e-9);
}

TEST(Clearance, OnePlacementOfManyJumpsInside) {
  const TriMesh small = makeBox(Vector3d::Constant(-1), Vector3d::Constant(1));
  const TriMesh big = makeBox(Vector3d::Constant(-20), Vector3d::Constant(20));
  std::vector<Pose> poses;
  for (int i = 0; i < 1000; ++i)
    poses.push_back(shifted(i, Vector3d(40 + 0.01 * i, std::sin(i), std::cos(i))));
  poses[617].translation = Vector3d(1, 2, 3);
  const NeighbourClearance row = checkOne(small, motionOf(poses, Interpolation::None), big);
  EXPECT_EQ(row.verdict, ClearanceVerdict::Clash);
  EXPECT_TRUE(row.inside);
  EXPECT_EQ(row.timeSeconds, 617);
  ASSERT_EQ(row.contact.size(), 1u);
  EXPECT_EQ(row.contact[0].from, 617);
  EXPECT_EQ(row.contact[0].to, 617);
}

TEST(Clearance, OpenNeighbourIsNamedAndStillMeasured) {
  TriMesh open = makeBox(Vector3d::Constant(-20), Vector3d::Constant(20));
  open.triangles.pop_back();
  const TriMesh small = makeBox(Vector3d::Constant(-1), Vector3d::Constant(1));
  RunContext run;
  const ClearanceReport report =
      checkClearance(small, motionOf({shifted(0, {30, 0, 0}), shifted(1, {24, 0, 0})}),
                     {{"sheet", open, 0}}, {}, run);
  ASSERT_EQ(report.neighbours.size(), 1u);
  EXPECT_FALSE(report.neighbours[0].closed);
  EXPECT_NEAR(report.neighbours[0].distance, 3, 1e-9);
  ASSERT_EQ(report.warnings.size(), 1u);
  EXPECT_EQ(report.warnings[0].code, "OpenMesh");
}

// A torus moves irregularly past a ball and a bar: the fast search is compared with distances of
// FCL at many times, with all three interpolations.
TEST(Clearance, AgreesWithStampingEveryPose) {
  std::mt19937 engine(5);
  const auto number = [&](double low, double high) {
    return low + (high - low) * (double(engine()) / double(std::mt19937::max()));
  };
  TriMesh part = makeBall({0, 0, 0}, 6, 3);
  append(part, makeBox({-2, 9, -40}, {2, 12, 40}));
  const TriMesh body = makeTorus(9, 2, 32, 16);
  const clearance::Part bodyTree(body, "body");
  const clearance::Part partTree(part, "part");
  const clearance::PairSearch pair(bodyTree, partTree);
  for (int round = 0; round < sampled(12, 4); ++round) {
    const Interpolation kind = static_cast<Interpolation>(round % 3);
    Trajectory motion{{}, kind};
    for (int i = 0; i < (kind == Interpolation::None ? 400 : 6); ++i) {
      motion.poses.push_back(
          poseOf(i, placement(Vector3d(number(-1, 1), number(-1, 1), number(-1, 1)), number(0, 60),
                              Vector3d(number(16, 40), number(14, 40), number(-30, 30)))));
    }
    ClearanceOptions options;
    options.required = 8;
    options.curveSamples = 50;
    const NeighbourClearance row = checkOne(body, motion, part, options);
    RunContext run;
    const std::vector<Pose> dense = clearance::densePoses(motion, 60);
    const clearance::StampedMinimum stamped = clearance::stampEveryPose(body, dense, part, run);
    if (kind == Interpolation::None) {
      EXPECT_NEAR(row.distance, stamped.distance, 1e-9) << round;
      if (stamped.distance > 0) {
        EXPECT_EQ(row.timeSeconds, dense[stamped.pose].timeSeconds);
      }
    } else {
      EXPECT_LE(row.distance, stamped.distance + options.tolerance) << round;
      // The result is at most the smallest sampled distance, up to the accuracy, and FCL finds the
      // same distance at the reported pose.
      EXPECT_NEAR(clearance::stampEveryPose(body, {row.pose}, part, run).distance, row.distance,
                  1e-9);
    }
    for (std::size_t i = 0; i < dense.size(); i += 7) {
      // Every sampled time with less than the required distance lies in a reported interval.
      const double d =
          pair.distanceAt(dense[i].rotation.toRotationMatrix(), dense[i].translation, 1e9).distance;
      bool listed = false;
      for (const TimeInterval& span : row.below)
        listed |= span.from <= dense[i].timeSeconds && dense[i].timeSeconds <= span.to;
      if (d < options.required) {
        EXPECT_TRUE(listed) << round << " at " << dense[i].timeSeconds;
      }
      if (kind == Interpolation::None && d >= options.required) {
        EXPECT_FALSE(listed);
      }
      if (d > options.required + 0.3) {
        EXPECT_FALSE(listed) << round << " at " << dense[i].timeSeconds;
      }
      if (i > 1500) break;
    }
    for (const CurvePoint& p : row.curve) EXPECT_GE(p.distance, row.distance - options.tolerance);
  }
}

TEST(Clearance, SameNumbersForAnyCountOfThreads) {
  TurningBar c;
  const TriMesh ball = makeBall({70, 70, 20}, 10, 3);
  std::string texts[2];
  for (int k = 0; k < 2; ++k) {
    RunContext run;
    run.threads = k + 1;
    ClearanceOptions options;
    options.required = 30;
    ClearanceReport report =
        checkClearance(c.bar, c.motion(Interpolation::Linear),
                       {{"post", c.post(99), 0}, {"ball", ball, 0}}, options, run);
    ASSERT_EQ(report.status, Status::Ok) << report.message;
    report.seconds.clear();
    report.threads = 0;
    for (NeighbourClearance& row : report.neighbours) row.seconds = 0;
    texts[k] = toJson(report);
  }
  EXPECT_EQ(texts[0], texts[1]);
}

TEST(Clearance, CancelAtAnyCheckpointLeavesNoResult) {
  TurningBar c;
  RunContext whole;
  ASSERT_EQ(
      checkClearance(c.bar, c.motion(Interpolation::Linear), {{"post", c.post(99), 0}}, {}, whole)
          .status,
      Status::Ok);
  EXPECT_EQ(whole.progress(), 1.0);
  const std::uint64_t count = CheckpointHook::passed(whole);
  ASSERT_GT(count, 5u);
  for (std::uint64_t at = 1; at <= count; at += std::max<std::uint64_t>(1, count / 12)) {
    RunContext run;
    CheckpointHook::cancelAt(run, at);
    const ClearanceReport report =
        checkClearance(c.bar, c.motion(Interpolation::Linear), {{"post", c.post(99), 0}}, {}, run);
    EXPECT_EQ(report.status, Status::Cancelled);
    EXPECT_TRUE(report.neighbours.empty());
    EXPECT_TRUE(report.summary.empty());
  }
}

TEST(Clearance, BadInputIsNamed) {
  const TriMesh box = makeBox(Vector3d::Zero(), Vector3d::Ones());
  TriMesh broken = box;
  broken.vertices[3].y() = std::nan("");
  const Trajectory motion = motionOf({shifted(0, {0, 0, 0}), shifted(1, {5, 0, 0})});
  const auto codeOf = [&](const TriMesh& body, const Trajectory& m,
                          std::vector<ClearanceNeighbour> parts, ClearanceOptions o = {}) {
    RunContext run;
    const ClearanceReport report = checkClearance(body, m, parts, o, run);
    EXPECT_EQ(report.status, Status::InvalidInput);
    EXPECT_FALSE(report.message.empty());
    return report.code;
  };
  EXPECT_EQ(codeOf(box, motion, {}), "NoNeighbours");
  EXPECT_EQ(codeOf(box, motion, {{"a", broken, 0}}), "NonFiniteVertex");
  EXPECT_EQ(codeOf(box, motion, {{"a", TriMesh{}, 0}}), "EmptyMesh");
  EXPECT_EQ(codeOf(TriMesh{}, motion, {{"a", box, 0}}), "EmptyMesh");
  EXPECT_EQ(codeOf(box, motionOf({}), {{"a", box, 0}}), "EmptyTrajectory");
  ClearanceOptions options;
  options.tolerance = 0;
  EXPECT_EQ(codeOf(box, motion, {{"a", box, 0}}, options), "BadOption");
  for (const double wrong : {0.0, -1.0}) {
    options = {};
    options.intervalTolerance = wrong;
    EXPECT_EQ(codeOf(box, motion, {{"a", box, 0}}, options), "BadOption") << wrong;
  }
}

TEST(Clearance, SummaryNamesTheNearest) {
  const TriMesh box = makeBox(Vector3d::Zero(), Vector3d::Ones());
  RunContext run;
  const ClearanceReport report =
      checkClearance(box, motionOf({shifted(0, {0, 0, 0}), shifted(1, {5, 0, 0})}),
                     {{"far", makeBox({20, 0, 0}, {21, 1, 1}), 0},
                      {"near \"one\"", makeBox({9.25, 0, 0}, {10, 1, 1}), 0}},
                     {}, run);
  EXPECT_EQ(report.summary,
            "2 checked, smallest distance 3.25 mm (guaranteed: 3.24 mm) at t = 1 s (near \"one\")");
  EXPECT_NE(toJson(report).find("near \\\"one\\\""), std::string::npos);
}

TEST(Clearance, SummaryLeavesRoundingOut) {
  NeighbourClearance row;
  row.name = "wall";
  row.verdict = ClearanceVerdict::Contact;
  const auto textFor = [&](double distance) {
    row.distance = row.guaranteed = distance;
    return clearance::summaryOf({&row}, "1 checked", 0, clearance::Timed::No).text;
  };
  EXPECT_EQ(textFor(6.162e-16), "1 checked, 1 contact, smallest distance 0 mm (wall)");
  EXPECT_EQ(textFor(2e-6), "1 checked, 1 contact, smallest distance 2e-06 mm (wall)");
}

TEST(DistanceToMesh, SignedForClosedMeshes) {
  RunContext run;
  const TriMesh box = makeBox(Vector3d::Zero(), Vector3d::Constant(10));
  const std::vector<double> d =
      distanceToMesh({{5, 5, 5}, {5, 5, 9}, {5, 5, 12}, {13, 14, 5}}, box, run);
  EXPECT_NEAR(d[0], -5, 1e-12);
  EXPECT_NEAR(d[1], -1, 1e-12);
  EXPECT_NEAR(d[2], 2, 1e-12);
  EXPECT_NEAR(d[3], 5, 1e-12);
}

}  // namespace
}  // namespace swept
