// Installation paths: they are found and proven clear, and are the same for any number of
// threads. Where no path exists, none is reported.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <chrono>
#include <numbers>
#include <thread>

#include "support/path_cases.h"
#include "support/path_check.h"
#include "support/shapes.h"

namespace swept {
namespace {

using namespace test;
using Eigen::Vector3d;

PathReport solve(const PathCase& c, PathOptions options, int threads = 1) {
  RunContext run;
  run.threads = threads;
  return findPath(c.part, taskOf(c), neighboursOf(c), options, run);
}

Pose at(double x, double y, double z) {
  Pose pose;
  pose.translation = {x, y, z};
  return pose;
}

// A block of 2 mm between two walls 4 mm apart.
PathCase betweenWalls() {
  PathCase c;
  c.part = makeBox({-1, -1, -1}, {1, 1, 1});
  c.neighbours = {makeBox({-20, 2, -20}, {20, 4, 20}), makeBox({-20, -4, -20}, {20, -2, 20})};
  c.goal = at(0, 0, 0);
  c.start = at(50, 0, 0);
  c.clearance = 0.5;
  return c;
}

std::string codeOf(const PathCase& c, const PathOptions& options) {
  const PathReport report = solve(c, options);
  EXPECT_EQ(report.status, Status::InvalidInput) << report.summary;
  EXPECT_TRUE(report.path.poses.empty());
  return report.code;
}

TEST(FindPath, MadeUpProblemsHaveTheRightAnswersAndEveryPathIsClear) {
  int found = 0;
  for (unsigned number = 0; number < 45; ++number) {
    const PathCase c = pathCase(number);
    if (c.name == "hook" || c.name == "slot" || c.name == "elbow") continue;  // tested below
    PathOptions options = optionsOf(c);
    options.budgetSeconds = c.possible ? 1000 : 0.3;
    const PathReport report = solve(c, options);
    EXPECT_EQ(wrongWith(c, report), "") << number << " " << c.name;
    found += report.verdict == PathVerdict::Found;
  }
  EXPECT_GE(found, 15);
}

// The shortest path passes the edge of the wall at the required distance. There is room for a
// larger distance, so the path must keep farther away.
TEST(FindPath, PathsKeepAwayFromWhatTheyPass) {
  PathCase c;
  c.part = makeBox({-1, -1, -1}, {1, 1, 1});
  c.neighbours = {makeBox({-20, -0.5, -20}, {20, 0.5, 10})};
  c.start = at(0, -5, 7);
  c.goal = at(0, 5, 7);
  c.clearance = 0.1;
  for (const bool turns : {true, false}) {
    PathOptions options = patient(c);
    options.translationOnly = !turns;
    const PathReport report = solve(c, options);
    EXPECT_EQ(wrongWith(c, report), "");
    EXPECT_GT(report.clearance, 0.5) << turns;
    EXPECT_LT(report.length, 1.25 * 17) << turns;
    EXPECT_LE(report.path.poses.size(), 7u) << turns;
    EXPECT_TRUE(turns || report.turn == 0);
  }
}

TEST(FindPath, PartsThatHaveToTurnFindTheirWay) {
  for (const PathCase& c : {slotCase(3), elbowCase(5)}) {
    const PathReport report = solve(c, patient(c));
    EXPECT_EQ(wrongWith(c, report), "") << c.name;
    EXPECT_GT(report.turn, 0.5) << c.name;
    EXPECT_LE(report.path.poses.size(), 25u);
  }
}

// No time limit: each search is limited by a number of moves (about a second), so the result is
// the same on every machine.
TEST(FindPath, TurnsInNarrowPlacesAreFoundWithinFewMoves) {
  int found = 0;
  for (unsigned seed = 1; seed <= 3; ++seed)
    for (const PathCase& c : {slotCase(seed), hookCase(seed), elbowCase(seed), keyholeCase(seed),
                              keyCase(seed), hooksCase(seed)}) {
      PathOptions options = patient(c);
      options.mostSteps = 600000;
      options.tryLowerClearance = false;
      const PathReport report = solve(c, options);
      EXPECT_EQ(wrongWith(c, report), "") << c.name << " " << seed;
      found += report.verdict == PathVerdict::Found;
    }
  EXPECT_EQ(found, 18);
}

TEST(FindPath, TheCheckOfTheTestsSeesPlantedFaults) {
  const PathCase c = channelCase(4);
  const PathReport good = solve(c, optionsOf(c));
  ASSERT_EQ(wrongWith(c, good), "");
  PathReport straight = good;
  straight.path.poses = {c.start, c.goal};
  straight.path.poses[1].timeSeconds = 1;
  EXPECT_NE(wrongWith(c, straight), "");
  PathReport elsewhere = good;
  elsewhere.path.poses.back().translation += Vector3d(0.001, 0, 0);
  EXPECT_NE(wrongWith(c, elsewhere), "");
  PathReport none = good;
  none.verdict = PathVerdict::NotFound;
  none.path.poses.clear();
  EXPECT_NE(wrongWith(c, none), "");
}

TEST(FindPath, TheSameKeysForAnyCountOfThreadsAndAnotherSeedMayGiveOthers) {
  const PathCase c = elbowCase(5);
  PathOptions options = patient(c);
  const PathReport one = solve(c, options, 1);
  ASSERT_EQ(one.verdict, PathVerdict::Found);
  for (const int threads : {1, 2, 3}) {
    const PathReport other = solve(c, options, threads);
    ASSERT_EQ(other.path.poses.size(), one.path.poses.size()) << threads;
    for (std::size_t i = 0; i < one.path.poses.size(); ++i) {
      EXPECT_EQ(other.path.poses[i].translation, one.path.poses[i].translation);
      EXPECT_EQ(other.path.poses[i].rotation.coeffs(), one.path.poses[i].rotation.coeffs());
      EXPECT_EQ(other.path.poses[i].timeSeconds, one.path.poses[i].timeSeconds);
    }
    EXPECT_EQ(other.steps, one.steps);
  }
  options.seed = 2;
  const PathReport another = solve(c, options, 1);
  EXPECT_EQ(wrongWith(c, another), "");
}

TEST(FindPath, BadInputIsNamed) {
  const PathCase c = betweenWalls();
  PathOptions options = optionsOf(c);
  ASSERT_EQ(solve(c, options).verdict, PathVerdict::Found);
  PathCase bad = c;
  bad.neighbours.clear();
  EXPECT_EQ(codeOf(bad, options), "NoNeighbours");
  bad = c;
  bad.start = c.goal;
  EXPECT_EQ(codeOf(bad, options), "SamePose");
  bad = c;
  bad.goal = at(0, 1.5, 0);
  const PathReport inside = solve(bad, options);
  EXPECT_EQ(inside.code, "GoalBlocked");
  EXPECT_NE(inside.message.find("'part 1'"), std::string::npos) << inside.message;
  EXPECT_NE(inside.message.find("0.5 mm deep"), std::string::npos) << inside.message;
  EXPECT_NE(inside.message.find("; move the part, set a release distance of at least 5."),
            std::string::npos)
      << inside.message;
  bad = c;
  bad.start = at(0, -2.5, 0);
  EXPECT_EQ(codeOf(bad, options), "StartBlocked");
  PathOptions wide = options;
  wide.clearance = 1.25;
  const PathReport near = solve(c, wide);
  EXPECT_EQ(near.code, "GoalBlocked");
  EXPECT_NE(near.message.find("1 mm from"), std::string::npos) << near.message;
  PathOptions none = options;
  none.budgetSeconds = 0;
  EXPECT_EQ(codeOf(c, none), "BadOption");
  none = options;
  none.largestTurn = 4;
  EXPECT_EQ(codeOf(c, none), "BadOption");
  for (const std::int64_t wrong : {0, -1}) {
    none = options;
    none.mostSteps = wrong;
    EXPECT_EQ(codeOf(c, none), "BadOption") << wrong;
  }
  bad = c;
  bad.part.vertices[0].x() = std::nan("");
  EXPECT_EQ(codeOf(bad, options), "NonFiniteVertex");
  bad = c;
  bad.neighbours[1].triangles.clear();
  EXPECT_EQ(codeOf(bad, options), "EmptyMesh");
  RunContext run;
  PathTask nowhere;
  EXPECT_EQ(findPath(c.part, nowhere, neighboursOf(c), options, run).code, "NoStart");
}

TEST(FindPath, OpenNeighboursAreSaid) {
  PathCase c = betweenWalls();
  c.neighbours[0].triangles.pop_back();
  const PathReport report = solve(c, optionsOf(c));
  ASSERT_EQ(report.verdict, PathVerdict::Found);
  ASSERT_EQ(report.warnings.size(), 1u);
  EXPECT_EQ(report.warnings[0].code, "OpenMesh");
  EXPECT_NE(report.warnings[0].text.find("part 1"), std::string::npos);
}

TEST(FindPath, ExtractionByRadiusAndByDirection) {
  const PathCase c = betweenWalls();
  PathTask task;
  task.goal = c.goal;
  task.extraction = Extraction{60, {}};
  RunContext run;
  const PathReport radius = findPath(c.part, task, neighboursOf(c), optionsOf(c), run);
  ASSERT_EQ(radius.verdict, PathVerdict::Found) << radius.message;
  EXPECT_GE((radius.path.poses.front().translation - c.goal.translation).norm(), 60);
  task.extraction = Extraction{0, Vector3d(0, 0, 2)};
  const PathReport up = findPath(c.part, task, neighboursOf(c), optionsOf(c), run);
  ASSERT_EQ(up.verdict, PathVerdict::Found) << up.message;
  EXPECT_GE(up.path.poses.front().translation.z(), 21.5);
  EXPECT_EQ(up.path.poses.back().translation, c.goal.translation);
}

TEST(FindPath, TheLargestTurnIsKept) {
  PathCase c = slotCase(3);
  PathOptions options = optionsOf(c);
  options.translationOnly = true;
  options.budgetSeconds = 2;
  EXPECT_NE(solve(c, options).verdict, PathVerdict::Found);
  c = betweenWalls();
  c.start.rotation = Eigen::AngleAxisd(1, Vector3d::UnitZ());
  options = optionsOf(c);
  options.largestTurn = 0.5;
  EXPECT_EQ(codeOf(c, options), "BadOption");
  options.largestTurn = 1.1;
  const PathReport report = solve(c, options);
  ASSERT_EQ(report.verdict, PathVerdict::Found);
  for (const Pose& pose : report.path.poses)
    EXPECT_LE(pose.rotation.angularDistance(c.goal.rotation), 1.1 + 1e-9);
}

TEST(FindPath, ThatNoWayWithoutTurningExistsIsProvenOrNotSaid) {
  PathCase c = sealedCase(3);
  PathOptions options = patient(c);
  options.translationOnly = true;
  const PathReport sealed = solve(c, options);
  EXPECT_EQ(sealed.verdict, PathVerdict::NoTranslation) << sealed.summary << sealed.message;
  EXPECT_FALSE(sealed.budgetEnded);
  // In a channel and in tunnels with a corner, a translation exists.
  for (unsigned number = 0; number < 3; ++number) {
    c = number % 2 == 0 ? channelCase(number) : cornerCase(number);
    options = optionsOf(c);
    options.translationOnly = true;
    options.budgetSeconds = 2;
    EXPECT_NE(solve(c, options).verdict, PathVerdict::NoTranslation) << number;
  }
}

TEST(FindPath, PlacesOnTheWayArePassed) {
  const PathCase c = betweenWalls();
  PathTask task = taskOf(c);
  task.via = {at(40, 0, 30), at(0, 0, 40)};
  RunContext run;
  const PathReport report = findPath(c.part, task, neighboursOf(c), optionsOf(c), run);
  ASSERT_EQ(report.verdict, PathVerdict::Found) << report.message;
  std::size_t next = 0;
  for (const Pose& pose : report.path.poses)
    if (next < task.via.size() && (pose.translation - task.via[next].translation).norm() < 1e-9)
      ++next;
  EXPECT_EQ(next, task.via.size());
  task.via[1] = c.goal;
  task.via[1].translation.y() += 1.5;  // into a wall
  const PathReport inside = findPath(c.part, task, neighboursOf(c), optionsOf(c), run);
  EXPECT_EQ(inside.code, "ViaBlocked");
  EXPECT_NE(inside.message.find("at pose 2 on the way (via, counted from 1) the part overlaps"),
            std::string::npos)
      << inside.message;
  EXPECT_NE(inside.message.find("move or remove this pose"), std::string::npos) << inside.message;
}

TEST(FindPath, CancelEndsASearchSoon) {
  const PathCase c = sealedCase(1);
  RunContext run;
  run.threads = 2;
  PathReport report;
  std::thread search(
      [&] { report = findPath(c.part, taskOf(c), neighboursOf(c), optionsOf(c), run); });
  while (run.phase() != Phase::Turns) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  EXPECT_GT(run.progress(), 0);
  const auto begin = std::chrono::steady_clock::now();
  run.cancel();
  search.join();
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  EXPECT_EQ(report.status, Status::Cancelled);
  EXPECT_LT(took.count(), 0.2);
}

TEST(FindPath, ASearchWithoutSuccessSaysHowFarItCame) {
  const PathCase c = sealedCase(2);
  PathOptions options = patient(c);
  options.mostSteps = 2000;
  options.tryLowerClearance = false;
  const PathReport report = solve(c, options);
  EXPECT_EQ(report.status, Status::Ok);
  EXPECT_NE(report.verdict, PathVerdict::Found);
  EXPECT_GT(report.escape.distance, 0);
  ASSERT_FALSE(report.escape.blockers.empty());
  EXPECT_EQ(report.escape.blockers[0], "part 1");
  EXPECT_NE(toJson(report).find("\"blockers\""), std::string::npos);
}

TEST(FindPath, TheTimeLimitEndsEachMethod) {
  for (const bool turns : {false, true}) {
    const PathCase c = sealedCase(2);
    PathOptions options = patient(c);
    options.translationOnly = !turns;
    options.mostSteps = 20000;
    options.tryLowerClearance = false;
    const PathReport whole = solve(c, options);
    options.budgetSeconds = 1e-9;
    const PathReport ended = solve(c, options);
    EXPECT_TRUE(ended.budgetEnded);
    EXPECT_EQ(ended.verdict, PathVerdict::NotFound) << "nothing is proven in no time";
    EXPECT_LT(ended.steps, whole.steps / 50);
  }
}

}  // namespace
}  // namespace swept
