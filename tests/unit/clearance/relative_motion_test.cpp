// Bounds of a relative motion, compared with the true positions of points.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "clearance/relative_motion.h"

#include <gtest/gtest.h>

#include "clearance/swept_boxes.h"
#include "support/random_numbers.h"
#include "support/shapes.h"

namespace swept::clearance {
namespace {

using Eigen::Vector3d;
using namespace swept::test;

Trajectory randomMotion(Random& random, Interpolation kind, int poses) {
  Trajectory motion{{}, kind};
  double time = random.number(-1, 0);
  const Vector3d start = random.point(40);
  Eigen::Isometry3d place = placement(random.point(1), random.number(0, 360), start);
  for (int i = 0; i < poses; ++i) {
    motion.poses.push_back(poseOf(time, place));
    time += random.number(0.05, 1);
    const double degrees = random.number(0, i % 3 == 0 ? 90 : 4);
    place = placement(random.point(1), degrees, random.point(i % 2 ? 9 : 0.1)) * place;
  }
  return motion;
}

struct Two {
  TimedMotion body, frame;
  TimeInterval span;
};

Two randomTwo(Random& random, int round) {
  const auto kind = round % 2 ? Interpolation::Linear : Interpolation::Screw;
  const auto other = round % 4 < 2 ? Interpolation::Linear : Interpolation::Screw;
  const Vector3d half(4, 7, 2);
  Two two{{randomMotion(random, kind, 9), {3, -2, 8}, half},
          {randomMotion(random, other, round % 5 == 0 ? 1 : 13), {-30, 5, 1}, half},
          {}};
  two.span = {std::max(two.body.span().from, two.frame.span().from),
              std::min(two.body.span().to, two.frame.span().to)};
  return two;
}

Vector3d placed(const Pose& pose, const Vector3d& x) {
  return pose.rotation * x + pose.translation;
}

TEST(RelativeMotion, NoPointLeavesItsBounds) {
  Random random(5);
  for (int round = 0; round < 20; ++round) {
    const auto [body, frame, span] = randomTwo(random, round);
    const MotionTree motion = relativeMotion(body, frame, joinedTimes(body, frame, span));
    std::vector<MotionNode> nodes{motion.root()};
    for (std::size_t next = 0; next < nodes.size(); ++next) {
      const MotionNode node = nodes[next];
      const MotionBound bound = motion.bound(node);
      std::vector<std::int32_t> members;
      motion.listMembers(node, members);
      for (int k = 0; k < 10; ++k) {
        double u = members[static_cast<std::size_t>(random.number(0, 0.999) *
                                                    static_cast<double>(members.size()))];
        u += node.cluster >= 0 ? random.number(0, 1) : random.number(node.from, node.to);
        const double time = motion.timeAt(u);
        const Vector3d local(random.number(-1, 1), random.number(-1, 1), random.number(-1, 1));
        const Vector3d x = body.centre() + body.half().cwiseProduct(local);
        // The true position, from each motion separately, in world coordinates.
        const Pose back = frame.poseAt(time);
        const Vector3d world = placed(body.poseAt(time), x) - back.translation;
        const Vector3d seen = back.rotation.conjugate() * world;
        EXPECT_LE((placed(motion.poseAt(u), x) - seen).norm(), 1e-9);
        const Vector3d moved = seen - (bound.R * x + bound.t);
        ASSERT_LE(moved.norm(), bound.reach + 1e-9) << round;
        const Vector3d n = random.point(1).normalized();
        ASSERT_LE(n.dot(moved), bound.advance(n, x, Vector3d::Zero()) + 1e-9) << round;
        const Vector3d part = 0.3 * body.half();
        ASSERT_LE(n.dot(moved), bound.advance(n, x - part.cwiseProduct(local), part) + 1e-9);
      }
      if (motion.splits(node) && nodes.size() < 1500) motion.split(node, nodes);
    }
  }
}

// The bound must shrink with the time span, or no search would end.
TEST(RelativeMotion, BoundsShrinkWithTheSpan) {
  Random random(8);
  const auto [body, frame, span] = randomTwo(random, 3);
  const MotionTree motion = relativeMotion(body, frame, joinedTimes(body, frame, span));
  for (std::int32_t step = 0; step < motion.members(); ++step) {
    const double whole = motion.bound({-1, step, 0, 1}).reach;
    EXPECT_LT(motion.bound({-1, step, 0.5, 0.5 + 1.0 / 64}).reach, whole / 20 + 1e-9);
  }
}

TEST(SweptBoxes, ApartMeansApart) {
  Random random(9);
  int apart = 0;
  for (int round = 0; round < 60; ++round) {
    const auto [body, frame, span] = randomTwo(random, round);
    const SweptBoxes a(body, span), b(frame, span);
    const double within = random.number(0, 40);
    if (!a.staysApart(b, within)) continue;
    ++apart;
    for (int k = 0; k < 300; ++k) {
      const double time = random.number(span.from, span.to);
      const auto point = [&](const TimedMotion& of) {
        const Vector3d local(random.number(-1, 1), random.number(-1, 1), random.number(-1, 1));
        return placed(of.poseAt(time), of.centre() + of.half().cwiseProduct(local));
      };
      EXPECT_GT((point(body) - point(frame)).norm(), within);
    }
  }
  EXPECT_GT(apart, 5);
}

TEST(SweptBoxes, OnlyNearPairsAreNamed) {
  // Ten bodies in a row, 20 mm apart, 10 mm long: neighbours are 10 mm apart.
  std::vector<SweptBoxes> bodies;
  for (int i = 0; i < 10; ++i) {
    const Trajectory motion{{poseOf(0, placement({0, 0, 1}, 0, {20.0 * i, 0, 0})),
                             poseOf(1, placement({0, 0, 1}, 0, {20.0 * i, 50, 0}))},
                            Interpolation::Linear};
    bodies.emplace_back(TimedMotion(motion, Vector3d::Zero(), Vector3d::Constant(5)),
                        TimeInterval{0, 1});
  }
  EXPECT_EQ(nearPairs(bodies, 9.9).size(), 0u);
  const auto pairs = nearPairs(bodies, 10.1);
  ASSERT_EQ(pairs.size(), 9u);
  for (int i = 0; i < 9; ++i) EXPECT_EQ(pairs[static_cast<std::size_t>(i)], std::pair(i, i + 1));
}

}  // namespace
}  // namespace swept::clearance
