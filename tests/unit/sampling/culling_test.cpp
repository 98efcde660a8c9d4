// Signs of the culled sampling against those of all faces and patches, and against the copies of
// the body themselves, on 200 random motions.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <random>

#include "geometry/body_topology.h"
#include "geometry/ray_columns.h"
#include "grid/plan_grid.h"
#include "input/body_check.h"
#include "input/trajectory_check.h"
#include "motion/refine_motion.h"
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
    motion = refineMotion(body.mesh, path, 0.02 * options.cellSize, run);
    Eigen::AlignedBox3d box;
    for (const auto& v : body.mesh.vertices) box.extend(v);
    grid = planGrid(sweptBox(body.mesh, motion, run), box, options);
  }

  /// 1 for every lattice point that the outside reaches.
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
    // Brute force: points of the grid in some placement of the body. Snapping moves the surface by
    // less than 1e-4 cell, so a hair beside the point is asked as well.
    const RayColumns rays(scene.body.mesh);
    std::uniform_int_distribution<std::size_t> any(0, culled.size() - 1);
    for (int asked = 0; asked < 300; ++asked) {
      const std::size_t at = any(random);
      const auto k = static_cast<double>(at % scene.grid.points[2]);
      const auto j = static_cast<double>(at / scene.grid.points[2] % scene.grid.points[1]);
      const auto i = static_cast<double>(at / scene.grid.points[2] / scene.grid.points[1]);
      const Eigen::Vector3d x = scene.grid.origin + scene.grid.cell * Eigen::Vector3d(i, j, k);
      for (const Placement& p : scene.motion.placements) {
        bool inside = true;
        for (const double way : {-1e-4, 1e-4}) {
          const Eigen::Vector3d y = x + Eigen::Vector3d::Constant(way * scene.grid.cell);
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

}  // namespace
}  // namespace swept::test
