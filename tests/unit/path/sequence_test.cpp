// Sequences: each part is clear of the parts already in place. An order is found, and where none
// exists, none is reported.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "swept/sequence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "support/shapes.h"

namespace swept {
namespace {

using namespace test;
using Eigen::Vector3d;

struct Problem {
  std::vector<SequencePart> parts;
  std::vector<StillPart> still;
  SequenceOptions options;
};

SequencePart partOut(const std::string& name, const TriMesh& mesh, double radius) {
  SequencePart part{name, mesh, 0, {}};
  part.task.extraction = Extraction{radius, {}};
  return part;
}

/// Returns a shaft that is open at the top, 20 mm wide inside.
TriMesh shaft(double height) {
  TriMesh mesh = makeSquareRing(13, 10, 0, height);
  append(mesh, makeBox({-13, -13, -3}, {13, 13, 0.5}));
  return mesh;
}

/// Blocks on top of each other in a shaft. In the assembly, each block has to wait for those below
/// it. The list starts with the top block.
Problem stack(int count) {
  Problem p;
  p.still.push_back({"shaft", shaft(12 * count + 5), 0});
  for (int i = count; i-- > 0;) {
    const double z = 1 + 11 * i;
    p.parts.push_back(partOut("block" + std::to_string(i + 1), makeBox({-9, -9, z}, {9, 9, z + 10}),
                              40.0 + 12 * count));
  }
  p.options.path.clearance = 0.4;
  p.options.path.budgetSeconds = 1000;
  return p;
}

/// A block in a closed box.
Problem sealed() {
  TriMesh box = makeSquareRing(12, 6, -8, 8);
  append(box, makeBox({-12, -12, -14}, {12, 12, -7.9}));
  append(box, makeBox({-12, -12, 7.9}, {12, 12, 14}));
  Problem p;
  p.parts = {partOut("block", makeBox({-4, -4, -5}, {4, 4, 5}), 60), partOut("box", box, 60)};
  for (SequencePart& part : p.parts) part.task.extraction = Extraction{0, Vector3d(0, 0, 1)};
  p.options.path.clearance = 0.4;
  p.options.path.budgetSeconds = 1000;
  p.options.findOrder = true;
  return p;
}

/// Two links of a chain.
Problem links() {
  const TriMesh ring = makeSquareRing(12, 8, -2, 2);
  const TriMesh other = transformed(ring, placement({1, 0, 0}, 90, {10, 0, 0}));
  Problem p;
  p.parts = {partOut("left", ring, 60), partOut("right", other, 60)};
  p.options.path.clearance = 0.2;
  p.options.path.budgetSeconds = 1000;
  p.options.path.mostSteps = 3000;
  p.options.findOrder = true;
  return p;
}

SequenceReport solve(const Problem& p, int threads = 1, SequenceWatch* watch = nullptr) {
  RunContext run;
  run.threads = threads;
  SequenceReport report = findSequence(p.parts, p.still, p.options, run, watch);
  EXPECT_EQ(run.progress() == 1, report.status == Status::Ok);
  return report;
}

std::vector<std::string> orderOf(const SequenceReport& report) {
  std::vector<std::string> names;
  for (const SequenceStep& step : report.steps) names.push_back(report.names[step.part]);
  return names;
}

TriMesh placedAt(TriMesh mesh, const Pose& pose) {
  for (Vector3d& x : mesh.vertices) x = pose.rotation * x + pose.translation;
  return mesh;
}

// Checks each step again with the clearance check, from its keys on the timeline. Returns an
// empty text if all is right.
std::string wrongWith(const Problem& p, const SequenceReport& report) {
  if (report.verdict != SequenceVerdict::Found) return "not found: " + report.summary;
  if (report.steps.size() != p.parts.size()) return "parts are missing";
  std::vector<ClearanceNeighbour> there;
  for (const StillPart& part : p.still) there.push_back({part.name, part.mesh, part.chordError});
  double time = 0;
  for (const SequenceStep& step : report.steps) {
    const SequencePart& part = p.parts[step.part];
    const Trajectory& motion = report.timeline[step.part];
    const Pose goal = part.motion ? part.motion->poses.back() : part.task.goal;
    if (step.begin != time || step.end < step.begin) return part.name + " is not at its time";
    time = step.end;
    for (const Pose& pose : motion.poses) {
      const bool before = pose.timeSeconds <= step.begin, after = pose.timeSeconds >= step.end;
      const Pose& at = before ? motion.poses.front() : goal;
      if ((before || after) && !(at.translation == pose.translation))
        return part.name + " moves while it is another one's turn";
    }
    if (motion.poses.back().timeSeconds != report.duration) return part.name + " ends too early";
    if (!there.empty()) {
      ClearanceOptions options;
      options.required = p.options.path.clearance;
      RunContext run;
      for (const NeighbourClearance& row :
           checkClearance(part.mesh, motion, there, options, run).neighbours)
        if (row.verdict != ClearanceVerdict::Clear)
          return part.name + " is not clear of " + row.name;
    }
    there.push_back({part.name, placedAt(part.mesh, goal), part.chordError});
  }
  return {};
}

std::string codeOf(const Problem& p, std::string* message = nullptr) {
  const SequenceReport report = solve(p);
  EXPECT_EQ(report.status, Status::InvalidInput) << report.summary;
  EXPECT_TRUE(report.steps.empty());
  if (message != nullptr) *message = report.message;
  return report.code;
}

TEST(FindSequence, PartsComeInTheGivenOrder) {
  Problem p = stack(3);
  std::reverse(p.parts.begin(), p.parts.end());
  const SequenceReport report = solve(p);
  EXPECT_EQ(wrongWith(p, report), "");
  EXPECT_EQ(orderOf(report), (std::vector<std::string>{"block1", "block2", "block3"}));
  EXPECT_GE(report.clearance, 0.4);
  EXPECT_EQ(report.searches, 3);
}

TEST(FindSequence, AnOrderThatCannotBeSaysWhoWasStoppedByWhom) {
  Problem p = stack(2);  // the upper block first, so the lower one is stopped
  p.options.path.mostSteps = 2000;
  const SequenceReport report = solve(p);
  EXPECT_EQ(report.status, Status::Ok) << report.message;
  EXPECT_EQ(report.verdict, SequenceVerdict::NotFound);
  EXPECT_FALSE(report.budgetEnded);
  EXPECT_TRUE(report.timeline.empty());
  ASSERT_EQ(report.steps.size(), 2u);
  EXPECT_EQ(report.steps[0].path.verdict, PathVerdict::Found);
  const PathReport& lower = report.steps[1].path;
  EXPECT_EQ(lower.verdict, PathVerdict::NotFound);
  EXPECT_TRUE(lower.path.poses.empty());
  EXPECT_GT(lower.escape.distance, 0);
  EXPECT_NE(std::find(lower.escape.blockers.begin(), lower.escape.blockers.end(), "block2"),
            lower.escape.blockers.end());
  EXPECT_NE(report.summary.find("'block1'"), std::string::npos) << report.summary;
}

TEST(FindSequence, TheOnlyOrderIsFound) {
  for (const int count : {2, 4}) {
    Problem p = stack(count);
    p.options.findOrder = true;
    const SequenceReport report = solve(p);
    ASSERT_EQ(wrongWith(p, report), "");
    std::vector<std::string> only;
    for (int i = 1; i <= count; ++i) only.push_back("block" + std::to_string(i));
    EXPECT_EQ(orderOf(report), only);
  }
}

TEST(FindSequence, AGoodOrderIsKept) {
  Problem p;
  p.still.push_back({"floor", makeBox({-50, -50, -5}, {50, 50, 0}), 0});
  for (int i = 0; i < 4; ++i) {
    const double x = -30 + 15 * ((i * 3) % 4);
    p.parts.push_back(partOut("p" + std::to_string(i), makeBox({x, -5, 1}, {x + 10, 5, 11}), 80));
  }
  p.options.path.clearance = 0.5;
  p.options.findOrder = true;
  const SequenceReport report = solve(p);
  EXPECT_EQ(wrongWith(p, report), "");
  EXPECT_EQ(orderOf(report), (std::vector<std::string>{"p0", "p1", "p2", "p3"}));
}

TEST(FindSequence, TheFirstPartComesFreelyWhereNothingStands) {
  Problem p = stack(2);
  p.parts.push_back(partOut("shaft", p.still[0].mesh, 100));
  p.parts.back().task.extraction = Extraction{0, Vector3d(0, 0, -1)};
  p.still.clear();
  p.options.findOrder = true;
  // The blocks need not leave first: the shaft can be moved down off them. So the given order
  // works.
  const SequenceReport report = solve(p);
  EXPECT_EQ(wrongWith(p, report), "");
  EXPECT_EQ(report.steps.front().path.method, "nothing in the way");
}

TEST(FindSequence, TheCheckOfTheTestsSeesPlantedFaults) {
  Problem p = stack(2);
  p.options.findOrder = true;
  const SequenceReport good = solve(p);
  ASSERT_EQ(wrongWith(p, good), "");
  SequenceReport swapped = good;
  std::swap(swapped.steps[0].part, swapped.steps[1].part);
  EXPECT_NE(wrongWith(p, swapped), "");
  SequenceReport through = good;
  Trajectory& lower = through.timeline[good.steps[0].part];
  lower.poses.front().translation = Vector3d(80, 0, 0);
  EXPECT_NE(wrongWith(p, through), "");
  Problem tight = p;  // the gaps between the parts are 1 mm
  tight.options.path.clearance = 1.2;
  EXPECT_NE(wrongWith(tight, good), "");
}

TEST(FindSequence, ThatNoOrderExistsIsProvenOrNotSaid) {
  Problem p = sealed();
  p.options.path.translationOnly = true;
  const SequenceReport proven = solve(p);
  EXPECT_EQ(proven.verdict, SequenceVerdict::NoOrder) << proven.summary << proven.message;
  EXPECT_NE(proven.summary.find("in any order"), std::string::npos);
  const SequenceReport chain = solve(links());
  EXPECT_EQ(chain.verdict, SequenceVerdict::NotFound) << chain.summary << chain.message;
  EXPECT_FALSE(chain.budgetEnded);
  ASSERT_EQ(chain.steps.size(), 2u);
  EXPECT_EQ(chain.steps[0].path.escape.blockers, std::vector<std::string>{"right"});
  EXPECT_EQ(chain.steps[1].path.escape.blockers, std::vector<std::string>{"left"});
}

TEST(FindSequence, AMotionThatIsGivenIsCheckedAndKept) {
  Problem p = stack(2);
  std::reverse(p.parts.begin(), p.parts.end());
  Trajectory down{{Pose{}, Pose{}, Pose{}}};
  down.poses[0].translation = {50, 0, 100};
  down.poses[1].translation = {0, 0, 100};
  down.poses[1].timeSeconds = 2;
  down.poses[2].timeSeconds = 7;
  p.parts[1].motion = down;
  const SequenceReport report = solve(p);
  ASSERT_EQ(wrongWith(p, report), "");
  EXPECT_EQ(report.steps[1].path.method, "given");
  EXPECT_DOUBLE_EQ(report.steps[1].end - report.steps[1].begin, 7);
  p.parts[1].motion->poses[1].translation.x() = 5;  // too near to the wall of the shaft
  const SequenceReport through = solve(p);
  EXPECT_EQ(through.verdict, SequenceVerdict::NotFound);
  EXPECT_EQ(through.steps[1].path.escape.blockers, std::vector<std::string>{"shaft"});
  const std::string& near = through.steps[1].path.summary;
  EXPECT_EQ(near.rfind("at t = 6.15 s the part is 0.14", 0), 0u) << near;
  EXPECT_NE(near.find("mm from 'shaft', but 0.4 mm are required; reduce"), std::string::npos)
      << near;
  p.parts[1].motion->poses[1].translation.x() = 20;
  const std::string deep = solve(p).steps[1].path.summary;
  EXPECT_NE(deep.find("s the part overlaps 'shaft', "), std::string::npos) << deep;
  EXPECT_NE(deep.find("mm deep; change the motion there"), std::string::npos) << deep;
  p.options.findOrder = true;
  p.parts[0].motion = p.parts[1].motion;
  EXPECT_EQ(solve(p).verdict, SequenceVerdict::NoOrder);
}

TEST(FindSequence, PartsThatTouchAreReleased) {
  Problem p = stack(2);
  std::reverse(p.parts.begin(), p.parts.end());
  p.parts[0].mesh = makeBox({-9, -9, 0.5}, {9, 9, 10.5});
  p.parts[1].mesh = makeBox({-9, -9, 10.5}, {9, 9, 20});
  std::string message;
  EXPECT_EQ(codeOf(p, &message), "PartsTooNear");
  EXPECT_NE(message.find("0 mm apart"), std::string::npos) << message;
  p.options.path.release = 3;
  for (const bool find : {false, true}) {
    p.options.findOrder = find;
    const SequenceReport report = solve(p);
    ASSERT_EQ(report.verdict, SequenceVerdict::Found) << report.summary << report.message;
    EXPECT_EQ(orderOf(report), (std::vector<std::string>{"block1", "block2"}));
    EXPECT_EQ(report.steps[1].path.contacts, std::vector<std::string>{"block1"});
  }
  Trajectory down{{Pose{}, Pose{}}};
  down.poses[0].translation = {0, 0, 80};
  down.poses[1].timeSeconds = 4;
  p.options.findOrder = false;
  p.parts[1].motion = down;
  const SequenceReport given = solve(p);
  ASSERT_EQ(given.verdict, SequenceVerdict::Found) << given.summary << given.message;
  EXPECT_EQ(given.steps[1].path.contacts, std::vector<std::string>{"block1"});
  EXPECT_GE(given.steps[1].path.clearance, 0.4);
}

TEST(FindSequence, PairsMayAskForTheirOwn) {
  Problem p = stack(2);
  std::reverse(p.parts.begin(), p.parts.end());
  p.options.path.clearance = 1.5;  // all gaps are 1 mm
  EXPECT_EQ(codeOf(p), "PartsTooNear");
  p.options.rules = {{"block2", "block1", parseRule("0.5")},
                     {"block1", "shaft", parseRule("0.3")},
                     {"shaft", "block2", parseRule("0.9")}};
  EXPECT_EQ(solve(p).verdict, SequenceVerdict::Found);
  p.options.rules[0].rule = parseRule("ignore");
  const SequenceReport ignored = solve(p);
  EXPECT_EQ(ignored.verdict, SequenceVerdict::Found);
  EXPECT_NE(toJson(ignored).find("\"ignored\""), std::string::npos);
  p.options.rules[0] = {"block2", "nobody", parseRule("1")};
  EXPECT_EQ(codeOf(p), "UnknownPart");
}

TEST(FindSequence, TheSameBytesForAnyCountOfThreads) {
  // Quick methods solve the first problem; the second one needs searches in six dimensions.
  Problem found = stack(3), none = links();
  found.options.findOrder = true;
  for (const Problem& p : {found, none}) {
    const auto bytes = [&](int threads) {
      const std::string text = toJson(solve(p, threads));
      return text.substr(0, text.find("\"threads\""));
    };
    const std::string one = bytes(1);
    EXPECT_NE(one.find("\"moves\""), std::string::npos) << one;
    for (const int threads : {2, 3}) EXPECT_EQ(bytes(threads), one) << threads;
  }
}

TEST(FindSequence, BadInputIsNamed) {
  const Problem good = stack(2);
  Problem p = good;
  std::string message;
  p.parts.clear();
  EXPECT_EQ(codeOf(p), "NoParts");
  p = good;
  p.parts[1].name = p.parts[0].name;
  EXPECT_EQ(codeOf(p), "PartTwice");
  p = good;
  p.still[0].name = "block1";
  EXPECT_EQ(codeOf(p), "PartTwice");
  p = good;
  p.parts[0].task.goal.translation.z() = -2.5;
  EXPECT_EQ(codeOf(p, &message), "PartsIntersect");
  EXPECT_NE(message.find("'block2' and 'block1' overlap, 1.5 mm deep; move one of the parts, or "
                         "set a release distance of at least 15.3 mm"),
            std::string::npos)
      << message;
  p.options.path.release = 15.3;
  EXPECT_NE(solve(p).code, "PartsIntersect");
  p = good;
  p.options.path.budgetSeconds = 0;
  EXPECT_EQ(codeOf(p, &message), "BadOption");
  p = good;
  p.parts[1].task.extraction.reset();
  EXPECT_EQ(codeOf(p, &message), "NoStart");
  EXPECT_NE(message.find("'block1'"), std::string::npos) << message;
  p = good;
  p.parts[0].motion = Trajectory{{Pose{}}};
  EXPECT_EQ(codeOf(p, &message), "BadPose");
  EXPECT_NE(message.find("has 1 pose, but needs at least 2"), std::string::npos) << message;
  p.parts[0].motion = Trajectory{{Pose{}, Pose{}}};
  EXPECT_EQ(codeOf(p, &message), "EqualTimes");
  EXPECT_NE(message.find("key 2, at 0 s, is not later than the key before it, at 0 s"),
            std::string::npos)
      << message;
  p = good;
  p.parts[0].mesh.triangles.clear();
  EXPECT_EQ(codeOf(p, &message), "EmptyMesh");
  EXPECT_NE(message.find("'block2'"), std::string::npos) << message;
  p = good;
  p.parts.pop_back();
  p.still.clear();
  EXPECT_EQ(codeOf(p), "NoNeighbours");
  p = good;
  p.parts[0].task.extraction.reset();
  p.parts[0].task.start = Pose{};
  p.parts[0].task.start->translation = {11, 0, 0};
  EXPECT_EQ(codeOf(p, &message), "StartBlocked");
  EXPECT_NE(message.find("'block2'"), std::string::npos) << message;
}

TEST(FindSequence, CanBeWatchedAndCancelled) {
  const Problem p = [] {
    Problem chain = links();
    chain.options.path.mostSteps.reset();
    return chain;
  }();
  RunContext run;
  SequenceWatch watch;
  SequenceReport report;
  EXPECT_FALSE(watch.seen().part.has_value());
  std::thread search([&] { report = findSequence(p.parts, p.still, p.options, run, &watch); });
  while (!watch.seen().farthest) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_LT(run.progress(), 1);
  run.cancel();
  search.join();
  EXPECT_EQ(report.status, Status::Cancelled);
  EXPECT_TRUE(report.steps.empty());
}

}  // namespace
}  // namespace swept
