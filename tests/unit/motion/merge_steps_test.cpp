// Merged steps of recordings: brute force measures how far they deviate from the true motion.
// Motions that cannot be merged stay unchanged.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "motion/merge_steps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "motion/refine_motion.h"
#include "motion/step_path.h"
#include "support/shapes.h"
#include "support/source_check.h"
#include "support/swept_distance.h"
#include "swept/compute.h"

namespace swept::test {
namespace {

using Eigen::Vector3d;

/// Returns a smooth path with the noise of a recording. Some poses have the time of the previous
/// one.
Trajectory recording(std::mt19937& random, int poses, double travel, double turn, double noise,
                     Interpolation kind = Interpolation::Linear) {
  std::normal_distribution<double> normal(0, 1);
  const auto any = [&] { return Vector3d(normal(random), normal(random), normal(random)); };
  const Vector3d direction = any(), swing = any(), axis = any().normalized();
  Trajectory out;
  out.interpolation = kind;
  double time = 0;
  for (int n = 0; n < poses; ++n) {
    const double s = static_cast<double>(n) / poses;
    const Vector3d at = travel * (s * direction + 0.3 * std::sin(9 * s) * swing) + noise * any();
    if (n % 11 != 5) time += 0.01 * (1 + n % 3);
    out.poses.push_back(poseOf(time, placement(axis, turn * std::sin(5 * s), at)));
  }
  return out;
}

/// Returns the largest distance between a body vertex in the true motion and the same vertex on the
/// chord of `motion` at the same time. Checks each pose, and three times between successive poses.
/// If several steps contain a time, the nearest position counts.
double farthestOff(const TriMesh& body, const Trajectory& truth, const Motion& motion) {
  double most = 0;
  std::size_t first = 0;
  for (std::size_t i = 0; i + 1 < truth.poses.size(); ++i) {
    const StepPath path(truth.poses[i], truth.poses[i + 1], truth.interpolation);
    for (int quarter = 0; quarter <= 4; ++quarter) {
      const Pose pose = path.poseAt(quarter / 4.0);
      const auto offAt = [&](std::size_t k, double s) {
        const Placement &p = motion.placements[k], &q = motion.placements[k + 1];
        double off = 0;
        for (const Vector3d& v : body.vertices) {
          const Vector3d chord = (1 - s) * p.apply(v) + s * q.apply(v);
          off = std::max(off, (pose.rotation * v + pose.translation - chord).norm());
        }
        return off;
      };
      const double time = pose.timeSeconds;
      while (first + 1 < motion.steps() && motion.placements[first + 1].timeSeconds < time) ++first;
      double least = 1e300;
      for (std::size_t k = first; k < motion.steps() && motion.placements[k].timeSeconds <= time;
           ++k) {
        const double start = motion.placements[k].timeSeconds,
                     duration = motion.placements[k + 1].timeSeconds - start;
        if (duration > 0) {
          least = std::min(least, offAt(k, std::min(1.0, (time - start) / duration)));
        } else {
          // The step is a jump, which takes no time.
          least = std::min(least, offAt(k, quarter / 4.0));
        }
      }
      most = std::max(most, least);
    }
  }
  return most;
}

Motion refined(const TriMesh& body, const Trajectory& trajectory, double chord) {
  RunContext run;
  return refineMotion(body, trajectory, chord, run);
}

Motion merged(const TriMesh& body, const Trajectory& trajectory, double chord) {
  RunContext run;
  return mergeSteps(refined(body, trajectory, chord), body, chord, run);
}

TEST(MergeSteps, EveryPointStaysWithinTheBoundThatIsSaid) {
  std::mt19937 random(1);
  const TriMesh body = makeBox({-20, -10, -5}, {30, 20, 15});
  int saved = 0;
  for (int n = 0; n < 60; ++n) {
    const double chord = 0.05;
    const double noise = n % 3 == 0 ? 0 : 0.001 * (n % 5);
    const Interpolation kind = n % 2 == 0 ? Interpolation::Linear : Interpolation::Screw;
    Trajectory motion =
        recording(random, 1500, n % 4 == 0 ? 0.5 : 10, n % 3 == 1 ? 0 : 20, noise, kind);
    if (n % 5 == 2) {  // a single outlier
      motion.poses[700].translation += Vector3d(0, 0, 0.6 * chord);
    }
    const Motion all = refined(body, motion, chord), found = merged(body, motion, chord);
    SCOPED_TRACE(n);
    ASSERT_EQ(found.midpoints.size(), found.steps());
    EXPECT_LE(found.chordError, std::max(chord, all.chordError) * (1 + 1e-9));
    if (found.placements.size() == all.placements.size()) continue;
    ++saved;
    EXPECT_LE(2 * found.steps(), all.steps());
    EXPECT_GT(found.mergeError, 0);
    EXPECT_LE(found.mergeError, chord);
    EXPECT_LE(farthestOff(body, motion, found), found.chordError + 1e-9);
    EXPECT_EQ(found.placements.front().translation, all.placements.front().translation);
    EXPECT_EQ(found.placements.back().translation, all.placements.back().translation);
    EXPECT_EQ(found.placements.back().timeSeconds, all.placements.back().timeSeconds);
  }
  EXPECT_GT(saved, 30);
}

TEST(MergeSteps, MidpointsAndPosesBelongToTheMergedSteps) {
  std::mt19937 random(2);
  const TriMesh body = makeBox({-20, -10, -5}, {30, 20, 15});
  const double chord = 0.05;
  const Trajectory motion = recording(random, 3000, 5, 10, 0.001);
  const Motion found = merged(body, motion, chord);
  ASSERT_LT(found.placements.size(), 1000u);
  ASSERT_EQ(found.poses.size(), motion.poses.size());
  for (std::size_t i = 0; i < motion.poses.size(); ++i) {
    const std::size_t k = found.poses[i];
    EXPECT_LE(found.placements[k].timeSeconds, motion.poses[i].timeSeconds);
    if (k + 1 < found.placements.size()) {
      EXPECT_GE(found.placements[k + 1].timeSeconds, motion.poses[i].timeSeconds);
    } else {
      EXPECT_EQ(i + 1, motion.poses.size());
    }
  }
  for (std::size_t k = 0; k < found.steps(); ++k) {
    const Placement &p = found.placements[k], &q = found.placements[k + 1], &m = found.midpoints[k];
    EXPECT_NEAR(m.timeSeconds, (p.timeSeconds + q.timeSeconds) / 2, 1e-9);
    for (const Vector3d& v : body.vertices) {
      EXPECT_LE((m.apply(v) - (p.apply(v) + q.apply(v)) / 2).norm(), found.chordError + 1e-9);
    }
  }
}

TEST(MergeSteps, WhatSavesLittleStaysAsItIs) {
  std::mt19937 random(3);
  const TriMesh body = makeBox({-20, -10, -5}, {30, 20, 15});
  const auto expectSame = [&](const Trajectory& motion, double chord, const char* what) {
    const Motion all = refined(body, motion, chord), found = merged(body, motion, chord);
    ASSERT_EQ(found.placements.size(), all.placements.size()) << what;
    EXPECT_EQ(found.mergeError, 0) << what;
    EXPECT_EQ(found.chordError, all.chordError) << what;
    EXPECT_EQ(found.poses, all.poses) << what;
  };
  expectSame(recording(random, 2000, 5, 10, 1), 0.05, "noise far above the bound");
  expectSame(recording(random, 20, 100, 170, 0), 0.05, "a few keys");
  expectSame(recording(random, 2000, 1, 2, 0, Interpolation::None), 0.05, "a union");
  Trajectory still = recording(random, 2000, 1, 0, 0);
  for (Pose& pose : still.poses) pose.timeSeconds = 7;
  expectSame(still, 0.05, "no time passes");
}

Options at(double cell) {
  Options options;
  options.cellSize = cell;
  return options;
}

/// The envelope of a recording contains the body at each pose, up to the chord error and the error
/// that a surface in cells may have.
TEST(MergeSteps, TheEnvelopeLosesNoMoreThanItSays) {
  std::mt19937 random(4);
  const TriMesh body = makeBall({0, 0, 0}, 5, 3);
  const Trajectory motion = recording(random, 3000, 6, 30, 1e-4);
  const double cell = 0.5;
  RunContext run;
  const Result found = compute(body, motion, at(cell), run);
  ASSERT_EQ(found.report.status, Status::Ok) << found.report.message;
  EXPECT_LT(found.report.refinedPlacements, 1000);
  EXPECT_EQ(found.report.placements, 3000);
  EXPECT_GT(found.report.chordError, 0);
  EXPECT_LE(found.report.chordError, 0.02 * cell * (1 + 1e-9));
  const SweptDistance truth(body, motion, cell / 16);
  double most = 0;
  for (std::size_t v = 0; v < found.mesh.vertices.size(); v += 41) {
    most = std::max(most, std::abs(truth.distance(found.mesh.vertices[v])));
  }
  EXPECT_LT(most, 0.15 * cell);
}

TEST(MergeSteps, SourcesNameThePoseAndTimeOfTheGivenMotion) {
  std::mt19937 random(5);
  TriMesh body = makeBox({-3, -2, -1}, {3, 2, 1});
  for (std::int32_t t = 0; t < 12; ++t) body.faceOf.push_back(t / 2);
  Trajectory motion = recording(random, 3000, 6, 30, 0);
  for (std::size_t i = 0; i < motion.poses.size(); ++i) {
    motion.poses[i].timeSeconds = 0.01 * static_cast<double>(i);
  }
  Options options = at(0.25);
  options.sources = true;
  RunContext run;
  const Result found = compute(body, motion, options, run);
  ASSERT_EQ(found.report.status, Status::Ok) << found.report.message;
  ASSERT_LT(found.report.refinedPlacements, 1000);
  std::vector<double> off = sourceDistances(body, motion, found.sources);
  off.erase(std::remove(off.begin(), off.end(), -1.0), off.end());
  std::sort(off.begin(), off.end());
  ASSERT_FALSE(off.empty());
  const double quantile = off[static_cast<std::size_t>(0.99 * static_cast<double>(off.size()))];
  EXPECT_LT(quantile, 2 * found.report.chordError + 1e-3 * *options.cellSize);
  EXPECT_LT(off.back(), 0.25 * *options.cellSize);
  options.sources = false;
  const Result plain = compute(body, motion, options, run);
  EXPECT_EQ(plain.mesh.vertices, found.mesh.vertices);
  EXPECT_EQ(plain.mesh.triangles, found.mesh.triangles);
}

}  // namespace
}  // namespace swept::test
