// Long edges of a turning body are divided; nothing else about the body changes.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "motion/split_edges.h"

#include <gtest/gtest.h>

#include <cmath>

#include "check/mesh_check.h"
#include "motion/refine_motion.h"
#include "motion/step_path.h"
#include "support/checked_compute.h"
#include "support/shapes.h"

namespace swept::test {
namespace {

using V3 = Eigen::Vector3d;

constexpr double kMany = 1e12;

Trajectory quarterTurn(double radians) {
  const auto turned = [](double angle) {
    return Eigen::Isometry3d(Eigen::AngleAxisd(angle, V3(1, 2, 2).normalized()));
  };
  return {{poseOf(0, turned(0)), poseOf(1, turned(radians))}, Interpolation::Linear};
}

TEST(SplitEdges, NoEdgeIsLongerAndTheSurfaceIsTheSame) {
  RunContext run;
  TriMesh body = makeSquareRing(4, 3, 0, 7);
  // slender: its triangles have 1, 2 or 3 long edges.
  append(body, makeBox({20, 0, 0}, {20.5, 9, 0.25}));
  for (const double longest : {5.0, 1.0, 0.3}) {
    const TriMesh split = splitEdges(body, longest, run);
    EXPECT_LE(longestEdge(split), longest);
    EXPECT_NEAR(signedVolume(split), signedVolume(body), 1e-12 * signedVolume(body));
    EXPECT_NEAR(surfaceArea(split), surfaceArea(body), 1e-12 * surfaceArea(body));
    const MeshCheck check = checkMesh(split, run);
    EXPECT_TRUE(check.closed);
    EXPECT_TRUE(check.manifold);
    EXPECT_TRUE(check.oriented);
    EXPECT_EQ(check.degenerateTriangles, 0);
    for (std::size_t v = 0; v < body.vertices.size(); ++v) {
      EXPECT_EQ(split.vertices[v], body.vertices[v]);
    }
  }
}

TEST(SplitEdges, OnlyWhereItSavesWork) {
  RunContext run;
  const double cell = 0.05, chord = 0.02 * cell;
  const auto best = [&](const TriMesh& body, const Trajectory& motion) {
    return planApproximation(body, motion, chord, cell, kMany, true, run).longestEdge;
  };
  const TriMesh box = makeBox({0, 0, 0}, {10, 7, 5});
  EXPECT_LT(best(box, quarterTurn(M_PI / 2)), 2);
  Trajectory moved = quarterTurn(0);
  moved.poses[1].translation = V3(9, 1, 2);
  EXPECT_TRUE(std::isinf(best(box, moved)));
  Trajectory copies = quarterTurn(M_PI / 2);
  copies.interpolation = Interpolation::None;
  EXPECT_TRUE(std::isinf(best(box, copies)));
  EXPECT_TRUE(std::isinf(best(makeBall({0, 0, 0}, 5, 6), quarterTurn(M_PI / 2))));
}

/// A ball with a long rod beside it, and a turn in 40 steps. Only the few long edges of the rod
/// need more steps.
struct BallAndRod {
  BallAndRod() {
    append(body, makeBox({2, 0, 0}, {2.1, 0.1, 20}));
    for (int n = 0; n <= 40; ++n) {
      turn.poses.push_back(poseOf(n, Eigen::Isometry3d(Eigen::AngleAxisd(0.04 * n, V3::UnitX()))));
    }
    turn.interpolation = Interpolation::Linear;
  }
  TriMesh body = makeBall({0, 0, 0}, 1, 6);
  Trajectory turn;
};

TEST(SplitEdges, FewLongEdgesOfAFineBodyAreSplitAndTheBoundIsKept) {
  RunContext run;
  const double cell = 0.05, chord = 0.02 * cell;
  const BallAndRod c;
  const MotionApproximation how = planApproximation(c.body, c.turn, chord, cell, kMany, true, run);
  EXPECT_EQ(how.chord, chord);
  const TriMesh split = splitEdges(c.body, how.longestEdge, run);
  const Motion motion = refineMotion(split, c.turn, how.chord, run);
  EXPECT_LE(motion.chordError, chord * (1 + 1e-9));
  EXPECT_LT(split.triangles.size(), c.body.triangles.size() * 2);
  // Without splitting, the same bound needs ten times as many placements.
  EXPECT_GT(refineMotion(c.body, c.turn, chord, run).placements.size(),
            10 * motion.placements.size());
}

TEST(SplitEdges, TooManyCopiesMakeTheChordLarger) {
  RunContext run;
  const double cell = 0.05, chord = 0.002 * cell;
  const BallAndRod c;
  const auto copies = [&](const MotionApproximation& how) {
    return refineMotion(c.body, c.turn, how.chord, run).placements.size() * c.body.triangles.size();
  };
  const MotionApproximation all = planApproximation(c.body, c.turn, chord, cell, kMany, false, run);
  EXPECT_EQ(all.chord, chord);
  const double most = static_cast<double>(copies(all)) / 5;
  const MotionApproximation fewer =
      planApproximation(c.body, c.turn, chord, cell, most, false, run);
  EXPECT_GT(fewer.chord, chord);
  EXPECT_LT(static_cast<double>(copies(fewer)), 1.01 * most);
  // Twice as many placements as for a chord error of one cell are always allowed.
  EXPECT_LT(planApproximation(c.body, c.turn, chord, cell, 1, false, run).chord, cell);
}

/// A box turns about one of its edges. It sweeps a sector of a cylinder, and its own space at the
/// first and the last pose.
TEST(SplitEdges, ABoxIsFollowedWithFewPlacements) {
  const TriMesh box = makeBox({0, 0, 0}, {4, 1, 10});
  Trajectory turn;
  for (const double angle : {0.0, M_PI / 2}) {
    turn.poses.push_back(poseOf(angle, Eigen::Isometry3d(Eigen::AngleAxisd(angle, V3::UnitZ()))));
  }
  turn.interpolation = Interpolation::Linear;
  Options options;
  options.resolution = 128;
  const Result result = checkedCompute(box, turn, options);
  // Edges of 10 mm turn by 1.57 rad. If they were not split, the patches that they sweep from one
  // placement to the next would need about 2,500 placements to be flat enough. The arcs of the
  // vertices alone need fewer than 40 (piecesOf() in step_path.h).
  EXPECT_LT(result.report.refinedPlacements, 300);
  // The quarter of a disc that the far corner sweeps, and the two halves of the box beside it.
  const double area = 17 * M_PI / 4 + 4;
  EXPECT_NEAR(result.report.check.volume, 10 * area, 2e-3 * 10 * area);
}

}  // namespace
}  // namespace swept::test
