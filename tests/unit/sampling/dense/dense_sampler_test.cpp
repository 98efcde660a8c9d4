// The dense sampler, compared with brute force: the same points are outside, except in a stated
// band around the surface.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sampling/dense/dense_sampler.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/checkpoint_hook.h"
#include "geometry/body_topology.h"
#include "grid/plan_grid.h"
#include "motion/refine_motion.h"
#include "sampling/dense/placement_space.h"
#include "sampling/sampler.h"
#include "support/shapes.h"
#include "swept/compute.h"

namespace swept::test {
namespace {

/// Returns a wandering, smooth motion, like a vibration: sums of sines in all six coordinates.
Trajectory vibration(std::mt19937& random, int poses, double travel, double turn) {
  std::uniform_real_distribution<double> unit(-1, 1);
  struct Wave {
    Eigen::Vector3d shift, turn;
    double speed, phase;
  };
  std::vector<Wave> waves;
  for (int i = 0; i < 5; ++i) {
    Wave w;
    w.shift = Eigen::Vector3d(unit(random), unit(random), unit(random)) * travel;
    w.turn = Eigen::Vector3d(unit(random), unit(random), unit(random)) * turn;
    w.speed = 1 + 30 * std::abs(unit(random));
    w.phase = 3 * unit(random);
    waves.push_back(w);
  }
  Trajectory out;
  out.interpolation = Interpolation::None;
  for (int k = 0; k < poses; ++k) {
    const double t = k * 0.01;
    Eigen::Vector3d shift = Eigen::Vector3d::Zero(), w = Eigen::Vector3d::Zero();
    for (const Wave& wave : waves) {
      const double s = std::sin(wave.speed * t + wave.phase);
      shift += s * wave.shift;
      w += s * wave.turn;
    }
    out.poses.push_back(poseOf(t, placement(w, w.norm() * 180 / M_PI, shift)));
  }
  return out;
}

/// Returns a ball with bumps, which is convex in some places and concave in others, like a scanned
/// figure.
TriMesh bumpyBall(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  TriMesh ball = makeBall({0, 0, 0}, 20, 4);
  const Eigen::Vector3d a(unit(random), unit(random), unit(random));
  for (auto& v : ball.vertices) {
    const Eigen::Vector3d n = v.normalized();
    v *= 1 + 0.12 * std::sin(5 * n.x() + 3 * a.x()) * std::cos(4 * n.y() + 3 * a.y()) +
         0.05 * std::sin(9 * n.z() + a.z());
  }
  return ball;
}

struct Outside {
  std::vector<std::uint8_t> points;
};

Outside outsideOf(const MarkedEdges& marked, const GridPlan& grid) {
  RunContext run;
  const SignRuns signs = findOutside(marked, grid, run);
  Outside out;
  for (std::int32_t i = 0; i < grid.points[0]; ++i) {
    const LayerEdges& layer = marked.layers[i];
    for (std::int32_t j = 0; j < grid.points[1]; ++j) {
      std::uint32_t edge = layer.columnStart[2][j];
      std::uint32_t runIndex = signs.firstRun[signs.line(i, j)];
      for (std::int32_t k = 0; k < grid.points[2]; ++k) {
        for (; edge < layer.columnStart[2][j + 1] && layer.edges[2][edge].k < k; ++edge) ++runIndex;
        out.points.push_back(signs.outside[runIndex]);
      }
    }
  }
  return out;
}

struct Comparison {
  std::int64_t points = 0, tooSmall = 0, tooLarge = 0, surface = 0;
};

Comparison compareWithBruteForce(const TriMesh& body, const Trajectory& trajectory,
                                 int resolution) {
  RunContext run;
  Options options;
  options.resolution = resolution;
  const Motion motion = refineMotion(body, trajectory, 1, run);
  Eigen::AlignedBox3d box;
  for (const auto& v : body.vertices) box.extend(v);
  const GridPlan grid = planGrid(sweptBox(body, motion, run), box, options);
  const BodyTopology topology = buildTopology(body);
  const SamplerInput input{body, topology, motion, grid, true, true};
  dense::DenseSettings settings;
  settings.minPairs = 0;
  const auto dense = dense::sampleDense(input, settings, run);
  EXPECT_TRUE(dense.has_value());
  if (!dense) return {};
  const Outside found = outsideOf(dense->marked, grid);
  const Outside wanted = outsideOf(sampleCpu(input, run), grid);
  Comparison out;
  out.points = static_cast<std::int64_t>(wanted.points.size());
  for (std::size_t i = 0; i < wanted.points.size(); ++i) {
    out.tooSmall += found.points[i] && !wanted.points[i];
    out.tooLarge += !found.points[i] && wanted.points[i];
  }
  out.surface = 6 * static_cast<std::int64_t>(std::pow(double(out.points), 2.0 / 3));
  return out;
}

TEST(PlacementSpace, SupportIsTheBestOfAll) {
  std::mt19937 random(1);
  RunContext run;
  const TriMesh body = bumpyBall(random);
  const Motion motion = refineMotion(body, vibration(random, 3000, 1, 0.02), 1, run);
  const dense::PlacementSpace space(body, motion.placements);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector3d n =
        Eigen::Vector3d(unit(random), unit(random), unit(random)).normalized();
    const dense::Point6 g = space.gradient(body.vertices[i], n);
    const auto best = space.support(g, 0);
    float highest = -1e30f;
    for (std::uint32_t k = 0; k < 3000; ++k)
      highest = std::max(highest, dense::dot(g, space.point(k)));
    EXPECT_EQ(best.advance, highest);
    EXPECT_EQ(space.support(g, 1234).placement, best.placement) << "the guess changed the answer";
  }
}

TEST(PlacementSpace, AdvanceIsThatOfTheTrueMotionUpToTheRemainder) {
  std::mt19937 random(2);
  RunContext run;
  const TriMesh body = bumpyBall(random);
  const Motion motion = refineMotion(body, vibration(random, 300, 1, 0.02), 1, run);
  const dense::PlacementSpace space(body, motion.placements);
  EXPECT_GT(space.remainder(), 0);
  for (std::uint32_t k = 0; k < 300; ++k) {
    const Eigen::Vector3d& x = body.vertices[k];
    const Eigen::Vector3d n = x.normalized();
    const double exact =
        (space.mean().rotation * n).dot(motion.placements[k].apply(x) - space.mean().apply(x));
    EXPECT_NEAR(dense::dot(space.gradient(x, n), space.point(k)), exact,
                1.2 * space.remainder() + 1e-5);
  }
}

TEST(DenseSampler, SmoothBodiesHaveTheOutsideOfBruteForce) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    std::mt19937 random(seed);
    const TriMesh body = bumpyBall(random);
    const auto c = compareWithBruteForce(body, vibration(random, 300, 0.4, 0.01), 56);
    EXPECT_EQ(c.tooLarge, 0) << "seed " << seed;
    EXPECT_LE(c.tooSmall, c.surface / 500) << "seed " << seed;
  }
}

TEST(DenseSampler, CreasedBodiesHaveTheOutsideOfBruteForce) {
  for (unsigned seed = 11; seed <= 14; ++seed) {
    std::mt19937 random(seed);
    TriMesh body = makeCylinder(14, -9, 9, 48);
    if (seed % 2 == 0) body = makeSquareRing(16, 8, -5, 5);
    body = transformed(body, placement({1, 2, 3}, 31, {0, 0, 0}));
    const auto c = compareWithBruteForce(body, vibration(random, 400, 0.4, 0.01), 48);
    EXPECT_EQ(c.tooLarge, 0) << "seed " << seed;
    EXPECT_LE(c.tooSmall, c.surface / 500) << "seed " << seed;
  }
}

TEST(DenseSampler, LargeMotionsAndFewCopiesAreLeftToBruteForce) {
  std::mt19937 random(5);
  RunContext run;
  Options options;
  options.resolution = 32;
  const TriMesh body = bumpyBall(random);
  const BodyTopology topology = buildTopology(body);
  Eigen::AlignedBox3d box;
  for (const auto& v : body.vertices) box.extend(v);
  const auto applies = [&](double travel, double turn, double minPairs) {
    const Motion motion = refineMotion(body, vibration(random, 200, travel, turn), 1, run);
    const GridPlan grid = planGrid(sweptBox(body, motion, run), box, options);
    dense::DenseSettings settings;
    settings.minPairs = minPairs;
    return dense::sampleDense({body, topology, motion, grid, true, true}, settings, run)
        .has_value();
  };
  EXPECT_TRUE(applies(0.2, 0.01, 0));
  EXPECT_FALSE(applies(0.2, 0.01, 5e7));
  EXPECT_FALSE(applies(0.2, 0.5, 0));
  EXPECT_FALSE(applies(30, 0.01, 0));
}

TEST(DenseSampler, CanBeCancelledAtAnyCheckpoint) {
  std::mt19937 random(6);
  const TriMesh body = bumpyBall(random);
  Options options;
  options.resolution = 32;
  const Trajectory motion = vibration(random, 12000, 0.4, 0.01);
  for (const std::uint64_t at : {3u, 20u, 60u}) {
    RunContext run;
    CheckpointHook::cancelAt(run, at);
    EXPECT_EQ(compute(body, motion, options, run).report.status, Status::Cancelled) << at;
  }
}

TEST(DenseSampler, ComputeSaysWhatWasLeftOutAndDoesNotDependOnThreads) {
  std::mt19937 random(7);
  const TriMesh body = bumpyBall(random);
  Options options;
  options.resolution = 40;
  const Trajectory motion = vibration(random, 12000, 0.4, 0.01);
  RunContext one, two;
  one.threads = 1;
  two.threads = 2;
  const Result a = compute(body, motion, options, one), b = compute(body, motion, options, two);
  ASSERT_EQ(a.report.status, Status::Ok) << a.report.message;
  bool warned = false;
  for (const Finding& f : a.report.warnings) warned = warned || f.code == "DensePruned";
  EXPECT_TRUE(warned);
  EXPECT_EQ(a.mesh.triangles, b.mesh.triangles);
  EXPECT_TRUE(a.mesh.vertices == b.mesh.vertices);
}

}  // namespace
}  // namespace swept::test
