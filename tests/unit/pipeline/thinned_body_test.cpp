// Runs that sweep a thinned body: how far the envelope moves, what the report says, and which runs
// keep the body as it is.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pipeline/thinned_body.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "support/checked_compute.h"
#include "support/mesh_distance.h"
#include "support/shapes.h"
#include "swept/accuracy.h"

namespace swept::test {
namespace {

using Eigen::Vector3d;

/// Returns a motion to and fro along a curved path of this length (rad), in steps of which few are
/// merged.
Trajectory swing(int poses, double length = 40) {
  Trajectory motion;
  for (int n = 0; n < poses; ++n) {
    const double s = length * n / poses;
    motion.poses.push_back(poseOf(n, placement(Vector3d::UnitZ(), 40 * std::sin(s),
                                               {20 * std::sin(s), 5 * std::cos(1.7 * s), 0})));
  }
  return motion;
}

Options cells(int resolution) {
  Options options;
  options.resolution = resolution;
  return options;
}

TEST(ThinnedBody, TheEnvelopeMovesByNoMoreThanTheReportSays) {
  const TriMesh ball = makeBall({8, 0, 0}, 6, 6);
  const Result thin = checkedCompute(ball, swing(2000), cells(48));
  ASSERT_GT(thin.report.bodyDeviation, 0);
  EXPECT_NEAR(thin.report.bodyDeviation, 0.01 * thin.report.cellSize, 1e-3 * thin.report.cellSize);
  EXPECT_NE(toJson(thin.report).find("\"body_deviation\""), std::string::npos);
  EXPECT_GT(accuracyBound(thin.report),
            thin.report.cellSize + thin.report.chordError + thin.report.bodyDeviation);
  // With sources, the body stays as it is.
  Options exact = cells(48);
  exact.sources = true;
  const Result whole = checkedCompute(ball, swing(2000), exact);
  EXPECT_EQ(whole.report.bodyDeviation, 0);
  EXPECT_LT(thin.report.sweptPatches, whole.report.sweptPatches);
  // A thinned body also has other normals, which influence the vertices of the envelope. Their
  // distance from the other envelope must stay below a tenth of a cell.
  const MeshDistance distance(whole.mesh);
  for (const Vector3d& v : thin.mesh.vertices)
    ASSERT_LE(distance.distance(v), 0.1 * thin.report.cellSize);
}

TEST(ThinnedBody, IsAlsoUsedWithoutInterpolation) {
  const TriMesh ball = makeBall({8, 0, 0}, 6, 6);
  // The poses are so close together that the envelope is smooth between them.
  Trajectory poses = swing(2000, 3);
  poses.interpolation = Interpolation::None;
  const Result thin = checkedCompute(ball, poses, cells(48));
  ASSERT_GT(thin.report.bodyDeviation, 0);
  Options exact = cells(48);
  exact.sources = true;
  const Result whole = checkedCompute(ball, poses, exact);
  ASSERT_EQ(whole.report.bodyDeviation, 0);
  // The vertices in the valleys between the poses depend on the normals most.
  const MeshDistance distance(whole.mesh);
  double sum = 0;
  for (const Vector3d& v : thin.mesh.vertices) {
    const double d = distance.distance(v);
    ASSERT_LE(d, 0.25 * thin.report.cellSize);
    sum += d;
  }
  EXPECT_LE(sum / static_cast<double>(thin.mesh.vertices.size()), thin.report.bodyDeviation);
}

// The many triangles of the rod would need more memory than the limit permits, so its motion gets
// fewer placements than the chord tolerance requires. Once the rod is thinned, it gets all of them.
TEST(ThinnedBody, ShortMotionsThatWouldBeCappedUseIt) {
  const TriMesh rod = makeCylinder(3, -10, 10, 8000);
  Trajectory turns;
  for (int n = 0; n < 4; ++n)
    turns.poses.push_back(
        poseOf(n, placement(Vector3d(1, 2, 3).normalized(), 2.0 * n, {0, 0, 1.0 * n})));
  RunContext run;
  run.memoryLimitBytes = 200'000'000;
  const Result result = compute(rod, turns, cells(64), run);
  ASSERT_EQ(result.report.status, Status::Ok) << result.report.message;
  EXPECT_GT(result.report.bodyDeviation, 0);
  EXPECT_LE(result.report.chordError, 0.0201 * result.report.cellSize);
}

TEST(ThinnedBody, StaysAsItIsIfTheRunNeedsIt) {
  const TriMesh ball = makeBall({8, 0, 0}, 6, 5);
  EXPECT_EQ(checkedCompute(ball, swing(20), cells(24)).report.bodyDeviation, 0);
  EXPECT_GT(checkedCompute(ball, swing(2000), cells(24)).report.bodyDeviation, 0);
  Options grown = cells(24);
  grown.offset = 1;
  EXPECT_EQ(checkedCompute(ball, swing(2000), grown).report.bodyDeviation, 0);
  // Two balls that have an edge in common: the edge has four triangles.
  TriMesh pair = makeBall({0, 0, 0}, 6, 4);
  std::array<Vector3d, 2> edge{pair.vertices[pair.triangles[0][0]],
                               pair.vertices[pair.triangles[0][1]]};
  TriMesh second = pair;
  const Vector3d middle = (edge[0] + edge[1]) / 2;
  for (Vector3d& v : second.vertices) {
    v = 2 * middle - v;
    for (const Vector3d& end : edge) {
      if ((v - end).norm() < 1e-6) v = end;
    }
  }
  append(pair, second);
  for (const Interpolation interpolation : {Interpolation::Linear, Interpolation::None}) {
    Trajectory motion = swing(2000);
    motion.interpolation = interpolation;
    RunContext run;
    const Result result = compute(pair, motion, cells(24), run);
    EXPECT_EQ(result.report.status, Status::Ok) << result.report.message;
    EXPECT_EQ(result.report.bodyDeviation, 0);
    const auto& found = result.report.warnings;
    EXPECT_TRUE(std::any_of(found.begin(), found.end(),
                            [](const Finding& f) { return f.code == "NonManifoldEdges"; }));
  }
  // No vertex of a body of large flat faces can be removed.
  EXPECT_EQ(
      checkedCompute(makeBox({-3, -3, -3}, {3, 3, 3}), swing(2000), cells(24)).report.bodyDeviation,
      0);
}

}  // namespace
}  // namespace swept::test
