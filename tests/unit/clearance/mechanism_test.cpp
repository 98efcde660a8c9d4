// Mechanisms whose smallest distances follow from formulas, or are compared with distances at
// sampled times.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "swept/mechanism.h"

#include <gtest/gtest.h>

#include <cmath>
#include <thread>

#include "base/checkpoint_hook.h"
#include "support/mechanism_cases.h"
#include "support/sampled.h"
#include "support/shapes.h"

namespace swept {
namespace {

using Eigen::Vector3d;
using namespace swept::test;

Pose at(double time, const Vector3d& by) { return poseOf(time, placement({0, 0, 1}, 0, by)); }
Pose turned(double time, double degrees, const Vector3d& by) {
  return poseOf(time, placement({0, 0, 1}, degrees, by));
}
MechanismPart partOf(const std::string& name, TriMesh mesh, std::vector<Pose> poses,
                     Interpolation kind = Interpolation::Linear) {
  return {name, std::move(mesh), {std::move(poses), kind}, 0};
}
TriMesh cube(double half) { return makeBox(Vector3d::Constant(-half), Vector3d::Constant(half)); }

MechanismReport check(const std::vector<MechanismPart>& parts, const MechanismOptions& options = {},
                      int threads = 2) {
  RunContext run;
  run.threads = threads;
  return checkMechanism(parts, options, run);
}

const NeighbourClearance& only(const MechanismReport& report) {
  static const NeighbourClearance nothing;
  EXPECT_EQ(report.status, Status::Ok) << report.message;
  EXPECT_EQ(report.pairs.size(), 1u);
  return report.pairs.size() == 1 ? report.pairs[0].clearance : nothing;
}

// Two cubes of 10 mm that slide past each other in opposite directions, 3 mm apart in y.
TEST(Mechanism, CubesPassEachOther) {
  MechanismOptions options;
  options.required = 4;
  const MechanismReport report =
      check({partOf("left", cube(5), {at(0, {-40, 0, 0}), at(2, {40, 0, 0})}),
             partOf("right", cube(5), {at(0, {40, 13, 0}), at(2, {-40, 13, 0})})},
            options);
  const NeighbourClearance& row = only(report);
  EXPECT_NEAR(row.distance, 3, options.tolerance);
  EXPECT_EQ(row.verdict, ClearanceVerdict::BelowRequired);
  // The cubes are side by side while their middles are less than 10 mm apart in x. They approach
  // each other at 80 mm/s.
  EXPECT_GE(row.timeSeconds, 1 - 10.0 / 80 - 1e-9);
  EXPECT_LE(row.timeSeconds, 1 + 10.0 / 80 + 1e-9);
  ASSERT_EQ(row.below.size(), 1u);
  const double reach = (10 + std::sqrt(16.0 - 9.0)) / 80;
  EXPECT_NEAR(row.below[0].from, 1 - reach, 0.2 / 80);
  EXPECT_NEAR(row.below[0].to, 1 + reach, 0.2 / 80);
  // In world coordinates, the closest points lie on the facing sides, which do not move in y.
  EXPECT_NEAR(row.pointOnBody.y(), 5, 1e-9);
  EXPECT_NEAR(row.pointOnNeighbour.y(), 8, 1e-9);
  EXPECT_NEAR(report.pairs[0].poseOfFirst.translation.x(), 40 * (row.timeSeconds - 1), 1e-6);
  EXPECT_NEAR(report.pairs[0].poseOfSecond.translation.x(), -40 * (row.timeSeconds - 1), 1e-6);
  EXPECT_EQ(report.smallest, 0u);
  EXPECT_NE(report.summary.find("(left - right)"), std::string::npos) << report.summary;
}

// Two bars on axes 100 mm apart turn against each other, 45 degrees apart like the teeth of
// gears. They are nearest when one of them points at the axis of the other.
TEST(Mechanism, BarsTurnAgainstEachOther) {
  const TriMesh bar = makeBox({-60, -2, -5}, {60, 2, 5});
  std::vector<Pose> left, right;
  for (int i = 0; i <= 8; ++i) {
    left.push_back(turned(i, 45 * i, {0, 0, 0}));
    right.push_back(turned(i, 90 - 45 * i, {100, 0, 0}));
  }
  MechanismOptions options;
  options.range = 50;
  for (const Interpolation kind : {Interpolation::Linear, Interpolation::Screw}) {
    const MechanismReport report =
        check({partOf("left", bar, left, kind), partOf("right", bar, right, kind)}, options);
    const NeighbourClearance& row = only(report);
    double least = 1e300;  // smallest gap at many angles
    const auto gap = [&](double degrees) {
      const MechanismPart a = partOf("a", bar, {turned(0, degrees, {0, 0, 0})});
      const MechanismPart b = partOf("b", bar, {turned(0, 90 - degrees, {100, 0, 0})});
      RunContext run;
      return stampedPair(a, b, {}, 0, run).distance;
    };
    for (double degrees = 0; degrees < 90; degrees += 0.5) least = std::min(least, gap(degrees));
    EXPECT_LE(row.distance, least + 0.01);
    // Between two of these angles, an end of a bar moves 0.5 mm.
    EXPECT_GE(row.distance, least - 0.3);
    EXPECT_NEAR(gap(45 * row.timeSeconds), row.distance, 1e-6);
  }
}

// A cube and a post stand on a turntable. Relative to each other they do not move, and they pass
// a third part that stands still beside the table.
TEST(Mechanism, WhatMovesAsOneIsJoined) {
  std::vector<Pose> table;
  for (int i = 0; i <= 12; ++i) table.push_back(turned(i, 30 * i, {0, 0, 0}));
  const TriMesh rider = makeBox({20, -5, 0}, {30, 5, 10});
  const TriMesh post = makeBox({-30, -5, 0}, {-20, 5, 10});
  const TriMesh wall = makeBox({32, -5, 0}, {40, 5, 10});
  MechanismOptions options;
  options.range = 50;
  const MechanismReport report =
      check({partOf("rider", rider, table), partOf("post", post, table), partOf("wall", wall, {{}}),
             partOf("ground", transformed(wall, placement({0, 0, 1}, 90, {0, 0, 0})), {{}})},
            options);
  ASSERT_EQ(report.status, Status::Ok) << report.message;
  ASSERT_EQ(report.joined.size(), 1u);
  EXPECT_EQ(report.joined[0], (PartPair{0, 1}));
  ASSERT_EQ(report.pairs.size(), 4u);  // wall and ground are no pair: both stand still
  EXPECT_EQ(report.farPairs, 0);
  const double corner = std::hypot(30.0, 5.0);
  for (const PairClearance& pair : report.pairs)
    EXPECT_NEAR(pair.clearance.distance, 32 - corner, 0.01) << pair.clearance.name;
}

// While one part waits, the other passes: the wait is a part of the motion.
TEST(Mechanism, APartThatWaitsIsPassed) {
  const std::vector<Pose> gate{at(0, {0, 20, 0}), at(1, {0, 0, 0}), at(5, {0, 0, 0}),
                               at(6, {0, 20, 0})};
  const auto runner = [&](double start) {
    return partOf("runner", cube(2),
                  {at(0, {-30, -8, 0}), at(start, {-30, -8, 0}), at(start + 1, {30, -8, 0}),
                   at(6, {30, -8, 0})});
  };
  // The gate's lower face is at y = -5 while it waits, the runner's upper face at -6.
  const MechanismReport waits = check({partOf("gate", cube(5), gate), runner(3)});
  EXPECT_NEAR(only(waits).distance, 1, 0.01);
  EXPECT_NEAR(only(waits).timeSeconds, 3.5, 0.15);
  // If the wait were ignored, the gate would rise from t = 1 on and be far away at t = 4.75.
  const MechanismReport early = check({partOf("gate", cube(5), gate), runner(4.5)});
  EXPECT_NEAR(only(early).distance, 1, 0.01);
}

TEST(Mechanism, OneMovingPartIsAsForTheClearance) {
  const TriMesh body = makeTorus(9, 2, 32, 16);
  const TriMesh part = makeBall({18, 0, 3}, 4, 3);
  Trajectory motion;
  for (int i = 0; i < 6; ++i)
    motion.poses.push_back(poseOf(i, placement({1, 0.3, 0.1 * i}, 35 * i, {0.4 * i, -0.3 * i, 0})));
  for (const Interpolation kind : {Interpolation::Linear, Interpolation::Screw}) {
    motion.interpolation = kind;
    motion.pivot = {1, 2, 3};
    RunContext run;
    ClearanceOptions options;
    options.required = 2;
    const ClearanceReport single = checkClearance(body, motion, {{"ball", part, 0}}, options, run);
    MechanismOptions both;
    both.required = 2;
    both.range = 20;
    const MechanismReport report =
        check({{"body", body, motion, 0}, partOf("ball", part, {{}})}, both);
    const NeighbourClearance& row = only(report);
    const NeighbourClearance& known = single.neighbours.at(0);
    EXPECT_EQ(row.verdict, known.verdict);
    EXPECT_NEAR(row.distance, known.distance, options.tolerance);
    ASSERT_EQ(row.below.size(), known.below.size());
    for (std::size_t i = 0; i < row.below.size(); ++i)
      EXPECT_NEAR(row.below[i].from, known.below[i].from, 0.05);
    EXPECT_EQ(row.penetration.known, known.penetration.known);
    EXPECT_NEAR(row.penetration.depth, known.penetration.depth,
                0.02 * known.penetration.depth + 0.01);
  }
}

// A peg goes 2 mm deep into a plate, and both move. Depth, position and box are in world
// coordinates.
TEST(Mechanism, ClashOfTwoThatMove) {
  const MechanismReport report =
      check({partOf("plate", makeBox({-20, -20, -10}, {20, 20, 0}),
                    {at(0, {0, 0, 0}), at(1, {100, 0, 0}), at(2, {200, 0, 0})}),
             partOf("peg", makeCylinder(3, 0, 10, 32),
                    {at(0, {0, 0, 8}), at(1, {100, 0, -2}), at(2, {200, 0, 8})})});
  const NeighbourClearance& row = only(report);
  EXPECT_EQ(row.verdict, ClearanceVerdict::Clash);
  ASSERT_TRUE(row.penetration.known);
  EXPECT_NEAR(row.penetration.depth, 2, 0.03);
  EXPECT_NEAR(row.penetration.timeSeconds, 1, 0.01);
  EXPECT_FALSE(row.penetration.pointOfBody);
  EXPECT_NEAR(row.penetration.point.x(), 100, 4);
  EXPECT_NEAR(row.penetration.point.z(), -2, 0.03);
  EXPECT_GE(row.penetration.regionMin.x(), 100 - 3.1);
  EXPECT_LE(row.penetration.regionMax.x(), 100 + 3.1);
  EXPECT_NEAR(row.penetration.regionMin.z(), -2, 0.05);
}

TEST(Mechanism, PairsAreLeftOutAndFarOnesAreCounted) {
  std::vector<MechanismPart> parts;
  for (int i = 0; i < 6; ++i)
    parts.push_back(partOf(std::string(1, char('a' + i)), cube(5),
                           {at(0, {12.0 * i, 0, 0}), at(1, {12.0 * i, i % 2 ? 3.0 : -3.0, 0})}));
  MechanismOptions options;
  options.range = 3;
  const MechanismReport all = check(parts, options);
  ASSERT_EQ(all.status, Status::Ok) << all.message;
  ASSERT_EQ(all.pairs.size(), 5u);
  EXPECT_EQ(all.farPairs, 10);
  // Every second part has the same motion, but these parts are far apart.
  EXPECT_EQ(all.joined.size(), 0u);
  options.rules = {{"c", "b", parseRule("ignore")}};
  const MechanismReport less = check(parts, options);
  ASSERT_EQ(less.pairs.size(), 4u);
  ASSERT_EQ(less.ignored.size(), 1u);
  EXPECT_EQ(less.ignored[0], (PartPair{1, 2}));
  for (const PairClearance& pair : less.pairs) EXPECT_NE(pair.parts, (PartPair{1, 2}));
}

/// Two balls spin, and one of them also swings to the other and back, twice. At their nearest they
/// overlap by 6 mm or by 16 mm. A formula gives the times. Even a long overlap needs few distance
/// computations: a point of one ball deep inside the other proves an overlap for some time before
/// and after.
TEST(Mechanism, TimesOfSpinningBalls) {
  const double radius = 20, swing = 12, seconds = 4;
  const TriMesh ball = makeBall(Vector3d::Zero(), radius, 4);
  for (const double apart : {46.0, 36.0}) {
    std::vector<Pose> still, swinging;
    for (int i = 0; i <= 200; ++i) {
      const double time = seconds * i / 200;
      const double x = apart + swing * std::cos(M_PI * time);
      still.push_back(turned(time, 1.8 * i, {0, 0, 0}));
      swinging.push_back(turned(time, -2.7 * i, {x, 0, 0}));
    }
    MechanismOptions options;
    options.required = 5;
    options.curveSamples = 0;
    const MechanismReport report =
        check({partOf("still", ball, still), partOf("swinging", ball, swinging)}, options);
    const NeighbourClearance& row = only(report);
    const auto touching = [&](double level) {  // s below `level` in each swing of two seconds
      return 2 * std::acos((apart - 2 * radius - level) / swing) / M_PI;
    };
    const auto lengths = [](const std::vector<TimeInterval>& spans) {
      double sum = 0;
      for (const TimeInterval& span : spans) sum += span.to - span.from;
      return sum;
    };
    ASSERT_EQ(row.below.size(), 2u) << apart;
    // The balls have facets: they are up to 0.2 mm smaller, which is 0.02 s where the swing is
    // slow.
    EXPECT_NEAR(lengths(row.below), 2 * touching(5), 0.1);
    EXPECT_EQ(row.verdict, ClearanceVerdict::Clash);
    ASSERT_EQ(row.contact.size(), 2u) << apart;
    EXPECT_NEAR(lengths(row.contact), 2 * touching(0), 0.2);
    EXPECT_LT(row.distanceQueries, 3000) << apart;
  }
}

/// Three cubes in a row that rise and fall side by side: the first two 1 mm apart, the last two 0.2
/// mm into each other.
TEST(Mechanism, APairHasARuleOfItsOwn) {
  const double middles[] = {0, 11, 20.8};
  std::vector<MechanismPart> parts;
  for (int i = 0; i < 3; ++i)
    parts.push_back(
        partOf(std::string(1, char('a' + i)), cube(5),
               {at(0, {middles[i], 0, 0}), at(1, {middles[i], 0, i % 2 ? 2.0 : -2.0})}));
  MechanismOptions options;
  options.required = 0.5;
  const MechanismReport plain = check(parts, options);
  ASSERT_EQ(plain.pairs.size(), 2u) << plain.message;
  EXPECT_TRUE(plain.pairs[0].clearance.meetsRule());
  EXPECT_EQ(plain.pairs[1].clearance.verdict, ClearanceVerdict::Clash);
  options.rules = {{"b", "a", parseRule("1.5")}, {"b", "c", parseRule("contact:0.25")}};
  const MechanismReport ruled = check(parts, options);
  ASSERT_EQ(ruled.pairs.size(), 2u) << ruled.message;
  EXPECT_EQ(ruled.pairs[0].clearance.verdict, ClearanceVerdict::BelowRequired);
  EXPECT_EQ(ruled.pairs[0].required, 1.5);
  EXPECT_EQ(ruled.pairs[1].clearance.verdict, ClearanceVerdict::Contact);
  EXPECT_TRUE(ruled.pairs[1].clearance.meetsRule());
  EXPECT_GE(ruled.range, 1.5);
  options.rules[1].rule = parseRule("contact:0.15");  // less than the actual depth
  EXPECT_FALSE(check(parts, options).pairs[1].clearance.meetsRule());
}

TEST(Mechanism, BadInputIsNamed) {
  const auto moving = [&](const std::string& name, double from, double to) {
    return partOf(name, cube(1), {at(from, {0, 0, 0}), at(to, {9, 0, 0})});
  };
  const MechanismPart still = partOf("still", cube(1), {{}});
  const auto refused = [&](const std::vector<MechanismPart>& parts, const std::string& code,
                           const std::string& named, const MechanismOptions& options = {}) {
    const MechanismReport report = check(parts, options);
    EXPECT_EQ(report.status, Status::InvalidInput);
    EXPECT_EQ(report.code, code) << report.message;
    EXPECT_NE(report.message.find(named), std::string::npos) << report.message;
    EXPECT_TRUE(report.pairs.empty());
  };
  refused({moving("arm", 0, 1)}, "NoParts", "1 part was given");
  refused({moving("arm", 0, 1), moving("arm", 0, 1)}, "PartTwice", "'arm'");
  refused({still, partOf("post", cube(1), {{}})}, "NothingMoves", "none of the 2 parts");
  refused({moving("arm", 0, 1), moving("boom", 1, 2)}, "NoCommonTime", "'boom'");
  refused({moving("arm", 0, 1), partOf("boom", cube(1), {})}, "EmptyTrajectory", "'boom'");
  refused({moving("arm", 0, 0), still}, "EqualTimes", "'arm'");
  refused({moving("arm", 0, 1), {"boom", {}, {{{}}}, 0}}, "EmptyMesh", "'boom'");
  MechanismPart none = moving("arm", 0, 1);
  none.motion.interpolation = Interpolation::None;
  refused({none, still}, "NotInterpolated", "'arm'");
  MechanismPart half = moving("arm", 0, 1);
  half.motion.poses[1] = turned(1, 180, {0, 0, 0});
  refused({half, still}, "AmbiguousTurn", "'arm'");
  MechanismOptions options;
  options.rules = {{"still", "wheel", parseRule("ignore")}};
  refused({moving("arm", 0, 1), still}, "UnknownPart", "'wheel'", options);
  options.rules = {{"arm", "arm", parseRule("ignore")}};
  refused({moving("arm", 0, 1), still}, "UnknownPart", "twice", options);
  options.rules = {{"arm", "still", parseRule("3")}, {"still", "arm", parseRule("contact")}};
  refused({moving("arm", 0, 1), still}, "BadRule", "contradict", options);
  options.rules = {{"arm", "still", {-2}}};
  refused({moving("arm", 0, 1), still}, "BadRule", "'arm' and 'still'", options);
  options = {};
  for (const double range : {-1.0, 0.0}) {
    options.range = range;
    refused({moving("arm", 0, 1), still}, "BadOption", "range", options);
  }
  MechanismPart rough = still;
  rough.chordError = std::nan("");
  refused({moving("arm", 0, 1), rough}, "BadOption", "'still'");
}

TEST(Mechanism, MotionsThatGoOnAreNamed) {
  const MechanismReport report =
      check({partOf("short", cube(1), {at(1, {0, 0, 0}), at(2, {5, 0, 0})}),
             partOf("long", cube(1), {at(0, {0, 3, 0}), at(9, {5, 3, 0})})});
  ASSERT_EQ(report.status, Status::Ok);
  EXPECT_EQ(report.time.from, 1);
  EXPECT_EQ(report.time.to, 2);
  ASSERT_EQ(report.warnings.size(), 1u);
  EXPECT_EQ(report.warnings[0].code, "TimesCut");
  EXPECT_NE(report.warnings[0].text.find("long"), std::string::npos);
}

std::string withoutSeconds(MechanismReport report) {
  report.seconds.clear();
  report.threads = 0;
  for (PairClearance& pair : report.pairs) pair.clearance.seconds = 0;
  return toJson(report);
}

TEST(Mechanism, SameNumbersForAnyThreads) {
  for (unsigned seed = 3; seed < 3u + static_cast<unsigned>(sampled(4, 4)); ++seed) {
    const std::vector<MechanismPart> parts = randomMechanism(seed);
    const std::string one = withoutSeconds(check(parts, {}, 1));
    EXPECT_NE(one.find("\"status\": \"Ok\""), std::string::npos);
    EXPECT_EQ(one, withoutSeconds(check(parts, {}, 2)));
    EXPECT_EQ(one, withoutSeconds(check(parts, {}, 5)));
  }
}

TEST(Mechanism, CancelledAtAnyCheckpoint) {
  const std::vector<MechanismPart> parts = randomMechanism(1);
  RunContext whole;
  ASSERT_EQ(checkMechanism(parts, {}, whole).status, Status::Ok);
  EXPECT_EQ(whole.progress(), 1);
  ASSERT_GT(CheckpointHook::passed(whole), 10u);
  for (std::uint64_t n = 1; n < CheckpointHook::passed(whole) / 2;
       n += CheckpointHook::passed(whole) / 16 + 1) {
    RunContext run;
    CheckpointHook::cancelAt(run, n);
    const MechanismReport report = checkMechanism(parts, {}, run);
    EXPECT_EQ(report.status, Status::Cancelled);
    EXPECT_TRUE(report.pairs.empty());
    EXPECT_TRUE(report.summary.empty());
  }
}

// The larger number of cases is run by swept_mechanism_campaign.
TEST(Mechanism, NoPairIsMissed) {
  for (unsigned seed = 1000; seed < 1000u + static_cast<unsigned>(sampled(24, 8)); ++seed) {
    const std::vector<MechanismPart> parts = randomMechanism(seed);
    MechanismOptions options;
    options.required = 0.3;
    EXPECT_EQ(wrongWith(parts, check(parts, options), 15), "") << seed;
  }
}

TEST(Mechanism, TheWitnessSeesPlantedFaults) {
  const std::vector<MechanismPart> parts = randomMechanism(1001);
  const MechanismReport good = check(parts);
  ASSERT_EQ(wrongWith(parts, good, 15), "");
  ASSERT_FALSE(good.pairs.empty());
  const auto spoilt = [&](auto&& spoil) {
    MechanismReport bad = good;
    spoil(bad);
    return wrongWith(parts, bad, 15);
  };
  EXPECT_NE(spoilt([](MechanismReport& r) {
              r.pairs.erase(r.pairs.begin());
              ++r.farPairs;
            }),
            "");
  EXPECT_NE(spoilt([](MechanismReport& r) { r.pairs[0].clearance.distance += 0.1; }), "");
  EXPECT_NE(spoilt([](MechanismReport& r) { ++r.farPairs; }), "");
  EXPECT_NE(spoilt([](MechanismReport& r) {
              r.pairs[0].poseOfFirst.translation.x() += 50;
              r.pairs[0].clearance.inside = false;
            }),
            "");
}

}  // namespace
}  // namespace swept
