// The estimate from some patches, compared with the candidates of the whole body.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sampling/dense/dense_trial.h"

#include <gtest/gtest.h>

#include "geometry/body_topology.h"
#include "geometry/half_edges.h"
#include "grid/plan_grid.h"
#include "motion/refine_motion.h"
#include "sampling/dense/candidates.h"
#include "sampling/dense/dense_sampler.h"
#include "support/random_numbers.h"
#include "support/shapes.h"
#include "swept/compute.h"

namespace swept::test {
namespace {

/// Returns the motion of a part that stands still, as a recorder with noise reports it.
Trajectory trembling(int poses, double travel, double turn) {
  Random random(7);
  Trajectory out;
  out.interpolation = Interpolation::None;
  for (int k = 0; k < poses; ++k) {
    const Eigen::Vector3d axis = random.point(1), shift = random.point(travel);
    out.poses.push_back(poseOf(k * 0.01, placement(axis, axis.norm() * turn * 180 / M_PI, shift)));
  }
  return out;
}

/// Returns the number of candidates that the trial estimates, divided by the true number for the
/// whole body.
double ratioOfPairs(const TriMesh& body) {
  RunContext run;
  Options options;
  options.resolution = 48;
  const Motion motion = refineMotion(body, trembling(800, 0.3, 0.01), 1, run);
  Eigen::AlignedBox3d box;
  for (const auto& v : body.vertices) box.extend(v);
  const GridPlan grid = planGrid(sweptBox(body, motion, run), box, options);
  const BodyTopology topology = buildTopology(body);
  const SamplerInput input{body, topology, motion, grid, true, true};
  ListsByKey<> corners = halfEdgesByVertex(body);
  for (std::size_t v = 0; v < corners.keys(); ++v) corners.of(v);
  const dense::PlacementSpace space(body, motion.placements);
  const auto all = dense::findCandidates(input, space, dense::DenseSettings(), corners, run);
  const dense::DenseCost cost = dense::tryDense(input, 1e4, run);
  EXPECT_GT(cost.bytes, cost.pairs);
  return cost.pairs / static_cast<double>(all.placement.size());
}

// Candidates spread over eight rings of neighbours, so a patch without its surroundings misses most
// of them.
TEST(DenseTrial, MiddlesOfPatchesStandForTheBody) {
  const double ratio = ratioOfPairs(makeTorus(20, 8, 100, 60));
  EXPECT_GT(ratio, 0.8);
  EXPECT_LT(ratio, 1.25);
}

// All faces of a fan are neighbours, so candidates that one face finds reach all the others.
TEST(DenseTrial, HubsOfFansPassOnWhatFarFacesFind) {
  const double ratio = ratioOfPairs(makeCylinder(20, 0, 10, 3000));
  EXPECT_GT(ratio, 0.5);
  EXPECT_LT(ratio, 2);
}

}  // namespace
}  // namespace swept::test
