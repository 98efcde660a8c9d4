// The position filter: which poses it drops and keeps, and what the report says.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "motion/position_filter.h"

#include <gtest/gtest.h>

#include <random>

#include "support/mesh_distance.h"
#include "support/shapes.h"
#include "swept/compute.h"

namespace swept::test {
namespace {

/// Returns a motion of small random steps, and some larger ones.
Trajectory walk(std::mt19937& random, int poses, Interpolation interpolation) {
  std::normal_distribution<double> step(0, 1);
  Trajectory out;
  out.interpolation = interpolation;
  Eigen::Vector3d at = Eigen::Vector3d::Zero(), turn = Eigen::Vector3d::Zero();
  for (int n = 0; n < poses; ++n) {
    const double size = n % 7 == 0 ? 0.2 : 0.02;
    at += size * Eigen::Vector3d(step(random), step(random), step(random));
    turn += 0.1 * size * Eigen::Vector3d(step(random), step(random), step(random));
    out.poses.push_back(poseOf(n, placement(turn, turn.norm() * 180 / M_PI, at)));
  }
  return out;
}

double farthest(const TriMesh& body, const Pose& a, const Pose& b) {
  double most = 0;
  for (const auto& v : body.vertices) {
    most = std::max(most, (a.rotation * v + a.translation - b.rotation * v - b.translation).norm());
  }
  return most;
}

TEST(PositionFilter, DroppedPosesStayWithinTheDistanceOfTheKeptOneBefore) {
  std::mt19937 random(1);
  const TriMesh body = makeBall({1, 2, 0}, 3, 2);
  Eigen::AlignedBox3d box;
  for (const auto& v : body.vertices) box.extend(v);
  for (const double distance : {0.05, 0.3, 1.0}) {
    for (const Interpolation kind : {Interpolation::None, Interpolation::Linear}) {
      const Trajectory all = walk(random, 400, kind);
      const FilteredTrajectory found = filterPositions(all, box, distance);
      const auto& kept = found.trajectory.poses;
      ASSERT_EQ(static_cast<std::int64_t>(all.poses.size() - kept.size()), found.dropped);
      EXPECT_GT(found.dropped, 0);
      EXPECT_LE(found.distance, distance);
      EXPECT_EQ(kept.front().timeSeconds, 0);
      if (kind == Interpolation::Linear) {
        EXPECT_EQ(kept.back().timeSeconds, 399);
      }
      std::size_t k = 0;
      double most = 0;
      for (const Pose& pose : all.poses) {
        if (k + 1 < kept.size() && kept[k + 1].timeSeconds <= pose.timeSeconds) ++k;
        const double away = farthest(body, pose, kept[k]);
        if (pose.timeSeconds != kept[k].timeSeconds) most = std::max(most, away);
      }
      EXPECT_LE(most, found.distance + 1e-12) << "the body itself moves no farther than its box";
    }
  }
}

TEST(PositionFilter, TurnsBetweenKeptPosesStayBelowARightAngle) {
  Trajectory turning;
  for (int n = 0; n < 13; ++n) {
    turning.poses.push_back(poseOf(n, placement({0, 0, 1}, 40.0 * n, {0, 0, 0})));
  }
  Eigen::AlignedBox3d tiny(Eigen::Vector3d(-1, -1, -1), Eigen::Vector3d(1, 1, 1));
  const FilteredTrajectory found = filterPositions(turning, tiny, 100);
  EXPECT_GT(found.dropped, 0);
  const auto& kept = found.trajectory.poses;
  for (std::size_t k = 0; k + 1 < kept.size(); ++k) {
    EXPECT_LT(kept[k].rotation.angularDistance(kept[k + 1].rotation), M_PI / 2);
  }
  turning.interpolation = Interpolation::None;
  EXPECT_EQ(filterPositions(turning, tiny, 100).trajectory.poses.size(), 1u);
}

TEST(PositionFilter, TheRunSaysWhatWasDroppedAndTheEnvelopeLosesNoMore) {
  std::mt19937 random(2);
  const TriMesh body = makeTorus(5, 2, 32, 16);
  const Trajectory motion = walk(random, 60, Interpolation::None);
  Options options;
  options.cellSize = 0.25;
  RunContext run;
  const Result full = compute(body, motion, options, run);
  ASSERT_EQ(full.report.status, Status::Ok) << full.report.message;
  EXPECT_EQ(full.report.positionFilterDistance, 0);
  options.positionFilter = 0.5;
  const Result filtered = compute(body, motion, options, run);
  ASSERT_EQ(filtered.report.status, Status::Ok) << filtered.report.message;
  EXPECT_EQ(filtered.report.placements, 60);
  EXPECT_LT(filtered.report.refinedPlacements, 60);
  EXPECT_GT(filtered.report.positionFilterDistance, 0);
  EXPECT_LE(filtered.report.positionFilterDistance, 0.5);
  std::int64_t reported = 0;
  for (const Finding& finding : filtered.report.warnings) {
    if (finding.code == "PositionFiltered") reported = finding.count;
  }
  EXPECT_EQ(reported, 60 - filtered.report.refinedPlacements);
  // Each envelope may be off by one cell (tests/unit/truth). So the distance between both may
  // exceed the filter's distance by two cells.
  const double slack = 2 * *options.cellSize;
  const MeshDistance tree(filtered.mesh);
  for (const auto& v : full.mesh.vertices) {
    EXPECT_LE(tree.distance(v), filtered.report.positionFilterDistance + slack);
  }
}

}  // namespace
}  // namespace swept::test
