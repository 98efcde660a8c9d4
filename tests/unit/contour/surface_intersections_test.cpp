// Intersecting triangles found cell by cell, compared with a search over all pairs, before and
// after repair.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/mend/surface_intersections.h"

#include <gtest/gtest.h>

#include <random>

#include "contour/mend/mend.h"
#include "crossings/hermite.h"
#include "geometry/body_topology.h"
#include "geometry/certainly_apart.h"
#include "geometry/triangle_pairs.h"
#include "grid/plan_grid.h"
#include "input/body_check.h"
#include "input/trajectory_check.h"
#include "motion/refine_motion.h"
#include "sampling/sampler.h"
#include "signs/signs.h"
#include "support/random_case.h"
#include "support/shapes.h"

namespace swept::test {
namespace {

HermiteGrid sample(const TriMesh& raw, const Trajectory& trajectory, int resolution) {
  RunContext run;
  Options options;
  options.resolution = resolution;
  const CheckedBody body = checkBody(raw, options, run);
  const BodyTopology topology = buildTopology(body.mesh);
  const Trajectory checked = checkTrajectory(trajectory).trajectory;
  const Motion coarse = refineMotion(body.mesh, checked, 0.1, run);
  options.cellSize = plannedCell(sweptBox(body.mesh, coarse, run), options);
  const Motion motion = refineMotion(body.mesh, checked, 0.02 * *options.cellSize, run);
  Eigen::AlignedBox3d box;
  for (const auto& v : body.mesh.vertices) box.extend(v);
  const GridPlan grid = planGrid(sweptBox(body.mesh, motion, run), box, options);
  const SamplerInput input{body.mesh, topology, motion, grid, true, body.orientable};
  MarkedEdges marked = sampleCpu(input, run);
  const SignRuns signs = findOutside(marked, grid, run);
  return buildHermiteGrid(input, marked, signs, ExactTimes::Dropped, run);
}

TEST(SurfaceIntersections, SamePairsAsTheSearchOverAllBeforeAndAfterMending) {
  std::mt19937 random(20261121);
  RunContext run;
  std::int64_t before = 0, after = 0, unsure = 0, triangles = 0;
  for (int n = 0; n < 16; ++n) {
    const TriMesh body = randomBody(random);
    const Trajectory motion = randomMotion(random);
    const HermiteGrid grid = sample(body, motion, 20 + 4 * n);
    Surface surface = contourUniform(grid, Options{}, run);
    std::int64_t unsureHere = 0;
    const SelfIntersections found = findSurfaceIntersections(surface, grid, run, &unsureHere);
    EXPECT_EQ(found.pairs, findSelfIntersections(surface.mesh, {}, run).pairs) << "case " << n;
    before += found.count;
    unsure += unsureHere;
    triangles += static_cast<std::int64_t>(surface.mesh.triangles.size());

    const SelfIntersections left = mendSelfIntersections(surface, grid, found, run);
    EXPECT_EQ(left.pairs, findSelfIntersections(surface.mesh, {}, run).pairs) << "case " << n;
    after += left.count;
  }
  RecordProperty("pairs_before", static_cast<int>(before));
  RecordProperty("pairs_after", static_cast<int>(after));
  EXPECT_GT(before, 20) << "the cases test nothing";
  EXPECT_LT(after, before / 10);
  EXPECT_LT(unsure, triangles / 10) << "the local argument settles most triangles";
}

TEST(SurfaceIntersections, APlantedFaultIsFound) {
  RunContext run;
  std::mt19937 random(7);
  const HermiteGrid grid = sample(makeBall({0, 0, 0}, 2, 3), randomMotion(random), 40);
  Surface surface = contourUniform(grid, Options{}, run);
  ASSERT_EQ(findSurfaceIntersections(surface, grid, run).count, 0);
  // One vertex is moved to the far side of the body, and marked as outside its cell.
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (const auto& v : surface.mesh.vertices) centre += v;
  centre /= static_cast<double>(surface.mesh.vertices.size());
  surface.mesh.vertices[100] = centre - 1.1 * (surface.mesh.vertices[100] - centre);
  surface.cellFlags[100] = 0;
  const SelfIntersections found = findSurfaceIntersections(surface, grid, run);
  EXPECT_GT(found.count, 0);
  EXPECT_EQ(found.pairs, findSelfIntersections(surface.mesh, {}, run).pairs);
  // The same if the flag says wrongly that the vertex lies in its cell: the search notices that it
  // lies outside the cells of its polygons.
  surface.cellFlags[100] = 1;
  EXPECT_EQ(findSurfaceIntersections(surface, grid, run).pairs, found.pairs);
}

TEST(CertainlyApart, NeverSaysSoOfTrianglesThatMeet) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> coordinate(-2, 2), corner(0, 8);
  std::int64_t apart = 0, meet = 0;
  for (int n = 0; n < 20000; ++n) {
    TriMesh mesh;
    for (int v = 0; v < 9; ++v) {
      // Small integers: most triangles are coplanar, touch or overlap somewhere.
      mesh.vertices.emplace_back(coordinate(random), coordinate(random),
                                 n % 2 == 0 ? 0 : coordinate(random));
    }
    for (int t = 0; t < 2; ++t) {
      mesh.triangles.push_back({corner(random), corner(random), corner(random)});
    }
    if (hasNoArea(mesh, 0) || hasNoArea(mesh, 1)) continue;
    const bool meets = trianglesIntersect(mesh, 0, 1);
    const bool foundApart = certainlyApart(mesh, 0, 1);
    EXPECT_FALSE(meets && foundApart) << "case " << n;
    apart += foundApart;
    meet += meets;
  }
  EXPECT_GT(apart, 1000);
  EXPECT_GT(meet, 1000);
}

}  // namespace
}  // namespace swept::test
