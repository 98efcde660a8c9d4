// Signs from sampling with culling, compared with those from all faces and side patches, and
// with the copies of the body themselves, on 200 random motions.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <random>

#include "geometry/body_topology.h"
#include "geometry/ray_columns.h"
#include "grid/plan_grid.h"
#include "input/body_check.h"
#include "input/trajectory_check.h"
#include "motion/refine_motion.h"
#include "sampling/cpu/deep_inside.h"
#include "sampling/culling/face_clusters.h"
#include "sampling/culling/step_blocks.h"
#include "sampling/sampler.h"
#include "signs/contributing_edges.h"
#include "signs/signs.h"
#include "support/random_case.h"

namespace swept::test {
namespace {

struct Case {
  CheckedBody body;
  BodyTopology topology;
  Motion motion;
  GridPlan grid;

  Case(std::mt19937& random, int resolution) {
    RunContext run;
    Options options;
    options.resolution = resolution;
    body = checkBody(randomBody(random), options, run);
    topology = buildTopology(body.mesh);
    const Trajectory path = checkTrajectory(randomMotion(random)).trajectory;
    options.cellSize =
        plannedCell(sweptBox(body.mesh, refineMotion(body.mesh, path, 0.1, run), run), options);
    motion = refineMotion(body.mesh, path, 0.02 * *options.cellSize, run);
    Eigen::AlignedBox3d box;
    for (const auto& v : body.mesh.vertices) box.extend(v);
    grid = planGrid(sweptBox(body.mesh, motion, run), box, options);
  }

  /// Returns 1 for every lattice point that the outside reaches.
  std::vector<std::uint8_t> outside(bool cull) const {
    RunContext run;
    const SamplerInput input{body.mesh, topology, motion, grid, cull, body.orientable};
    const MarkedEdges marked = sampleCpu(input, run);
    const SignRuns signs = findOutside(marked, grid, run);
    std::vector<std::uint8_t> out;
    for (std::int32_t i = 0; i < grid.points[0]; ++i) {
      for (std::int32_t j = 0; j < grid.points[1]; ++j) {
        LineReader line(marked, signs, i, j);
        for (std::int32_t k = 0; k < grid.points[2]; ++k) out.push_back(line.outside(k));
      }
    }
    return out;
  }
};

TEST(Culling, SameSignsAsAllFacesAndNoCopyOfTheBodyIsOutside) {
  std::mt19937 random(200);
  std::int64_t inCopies = 0;
  for (int n = 0; n < 200; ++n) {
    SCOPED_TRACE("case " + std::to_string(n));
    const Case scene(random, 24);
    const std::vector<std::uint8_t> culled = scene.outside(true);
    EXPECT_EQ(culled, scene.outside(false));
    // Brute force, for 300 random lattice points: a point inside the body at some placement must
    // not be outside. Snapping moves the surface by less than 1e-4 cell. So a point counts as
    // inside only if both points beside it are, moved by -1e-4 and by 1e-4 cell along all axes.
    const RayColumns rays(scene.body.mesh);
    std::uniform_int_distribution<std::size_t> any(0, culled.size() - 1);
    for (int sample = 0; sample < 300; ++sample) {
      const std::size_t at = any(random);
      const auto k = static_cast<double>(at % scene.grid.points[2]);
      const auto j = static_cast<double>(at / scene.grid.points[2] % scene.grid.points[1]);
      const auto i = static_cast<double>(at / scene.grid.points[2] / scene.grid.points[1]);
      const Eigen::Vector3d x = scene.grid.origin + scene.grid.cell * Eigen::Vector3d(i, j, k);
      for (const Placement& p : scene.motion.placements) {
        bool inside = true;
        for (const double offset : {-1e-4, 1e-4}) {
          const Eigen::Vector3d y = x + Eigen::Vector3d::Constant(offset * scene.grid.cell);
          inside = inside && rays.winding(p.rotation.transpose() * (y - p.translation)) > 0;
        }
        if (!inside) continue;
        ++inCopies;
        EXPECT_EQ(culled[at], 0) << "lattice point " << i << " " << j << " " << k;
        break;
      }
    }
  }
  EXPECT_GT(inCopies, 3000);
}

/// Returns the crossings that count, as numbers: edge, sides, and for each side fraction and
/// element.
std::vector<std::array<double, 9>> counting(const SamplerInput& input) {
  RunContext run;
  const MarkedEdges marked = sampleCpu(input, run);
  const SignRuns signs = findOutside(marked, input.grid, run);
  std::vector<std::array<double, 9>> out;
  for (std::int32_t i = 0; i < input.grid.points[0]; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      forContributing(marked, signs, input.grid, i, axis,
                      [&](std::int32_t j, const MarkedEdge& edge, std::uint8_t sides) {
                        std::array<double, 9> row{};
                        row = {1.0 * i, 1.0 * axis, 1.0 * j, 1.0 * edge.k, 1.0 * sides};
                        const SweptElement &low = marked.elements[edge.lowElement],
                                           &high = marked.elements[edge.highElement];
                        if (sides & HermiteEdge::kLow) {
                          row[5] = edge.lowFraction;
                          row[6] = low.code + 4294967296.0 * low.placement;
                        }
                        if (sides & HermiteEdge::kHigh) {
                          row[7] = edge.highFraction;
                          row[8] = high.code + 4294967296.0 * high.placement;
                        }
                        out.push_back(row);
                      });
    }
  }
  return out;
}

/// Gives the case a motion like a recording that returns to the same positions, and a grid for this
/// motion.
void record(Case& scene, std::mt19937& random, int n) {
  std::uniform_real_distribution<double> unit(-1, 1);
  Eigen::AlignedBox3d box;
  for (const auto& v : scene.body.mesh.vertices) box.extend(v);
  const double size = box.diagonal().norm();
  // The body moves to and fro in all directions, with and without turning. The travel ranges from
  // tiny to the size of the body.
  const double travel = size * std::pow(10, -2 + n % 3), turn = n % 2 == 0 ? 0 : 0.3 * unit(random);
  const Eigen::Vector3d waves = 40 * Eigen::Vector3d(unit(random), unit(random), unit(random));
  const Eigen::Vector3d axis = Eigen::Vector3d(unit(random), unit(random), 1).normalized();
  scene.motion = Motion();
  scene.motion.continuous = n % 4 != 3;
  constexpr int kPlacements = 1500;
  for (int k = 0; k < kPlacements; ++k) {
    const double s = static_cast<double>(k) / kPlacements;
    const Eigen::Array3d wave = (waves.array() * s + Eigen::Array3d(0, 1, 2)).sin();
    scene.motion.placements.push_back(
        {Eigen::AngleAxisd(turn * wave[0], axis).toRotationMatrix(), travel * wave.matrix(), s});
  }
  RunContext run;
  Options options;
  options.resolution = 20;
  const Eigen::AlignedBox3d swept = sweptBox(scene.body.mesh, scene.motion, run);
  options.cellSize = plannedCell(swept, options);
  scene.grid = planGrid(swept, box, options);
}

TEST(Culling, WhatLiesInsideChangesNoCrossingThatCounts) {
  std::mt19937 random(77);
  int hiding = 0;
  for (int n = 0; n < 24; ++n) {
    SCOPED_TRACE("case " + std::to_string(n));
    Case scene(random, 20);
    if (!scene.body.orientable) continue;
    record(scene, random, n);
    RunContext run;
    SamplerInput input{scene.body.mesh, scene.topology, scene.motion, scene.grid, true, true};
    const auto all = counting(input);
    input.fillsHollows = true;
    const auto inside = findDeepInside(input, run);
    if (!inside) continue;  // too few points are deep inside
    input.inside = &*inside;
    std::uint64_t sampled = 0;
    input.crossings = &sampled;
    EXPECT_EQ(counting(input), all);
    input.inside = nullptr;
    std::uint64_t before = 0;
    input.crossings = &before;
    counting(input);
    hiding += sampled < before / 2;
  }
  EXPECT_GT(hiding, 5);  // otherwise nothing was compared
}

// Trials sample parts of a motion. They must find the same crossings there as a run.
TEST(Culling, PartsOfAMotionAreSampledAsInTheWhole) {
  std::mt19937 random(77);
  int grouped = 0;
  for (int n = 0; n < 24; ++n) {
    SCOPED_TRACE("case " + std::to_string(n));
    Case scene(random, 20);
    if (!scene.body.orientable) continue;
    record(scene, random, n);
    RunContext run;
    SamplerInput input{scene.body.mesh, scene.topology, scene.motion, scene.grid, true, true};
    input.fillsHollows = true;
    const auto inside = findDeepInside(input, run);
    if (!inside || !scene.motion.continuous) continue;
    input.inside = &*inside;
    const FaceClusters clusters = buildClusters(scene.body.mesh, scene.topology);
    input.clusters = &clusters;
    std::uint64_t whole = 0, part = 0, sum = 0;
    input.crossings = &whole;
    sampleCpu(input, run);
    input.crossings = &part;
    const PlacementGroups all(input, clusters, run);
    for (const PlacementRange& range : {PlacementRange{0, 400}, {400, 421}, {421, 1500}}) {
      PlacementGroups::Trial trial{{range}};
      const PlacementGroups groups(input, clusters, run, &trial);
      EXPECT_EQ(groups.empty(), all.empty());
      input.only = range;
      input.groups = &groups;
      sampleCpu(input, run);
      sum += part;
    }
    EXPECT_EQ(sum, whole);
    grouped += !all.empty() && whole > 0;
  }
  EXPECT_GT(grouped, 2);  // otherwise no group was decided
}

}  // namespace
}  // namespace swept::test
