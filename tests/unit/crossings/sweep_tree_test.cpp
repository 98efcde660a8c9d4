// The tree of all pieces of a motion against all pieces, one by one.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "crossings/sweep_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <utility>

#include "geometry/body_topology.h"
#include "input/body_check.h"
#include "input/trajectory_check.h"
#include "motion/refine_motion.h"
#include "support/random_case.h"

namespace swept::test {
namespace {

using Eigen::Vector3d;
using Key = std::pair<std::uint32_t, std::uint32_t>;

/// Returns the fraction of the segment at which it meets the triangle; 2 if it does not.
double meetsAt(const Vector3d& from, const Vector3d& way, const Vector3d& a, const Vector3d& b,
               const Vector3d& c) {
  const Vector3d n = (b - a).cross(c - a);
  const double s = n.dot(a - from) / n.dot(way);
  if (!(s >= 0 && s <= 1)) return 2;
  const Vector3d x = from + s * way;
  for (const auto& [p, q] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
    if (n.dot((q - p).cross(x - p)) < 0) return 2;
  }
  return s;
}

/// All pieces of the sweep, in grid coordinates.
struct Pieces {
  const SamplerInput& input;
  std::vector<Placement> placements;

  explicit Pieces(const SamplerInput& of) : input(of) {
    for (const Placement& p : of.motion.placements) placements.push_back(of.grid.toGrid(p));
  }
  double meetsAt(const SweptElement& element, const Vector3d& from, const Vector3d& way) const {
    const Placement& p = placements[element.placement];
    const auto& x = input.body.vertices;
    if (!element.isSidePatch()) {
      const auto& t = input.body.triangles[element.index()];
      return test::meetsAt(from, way, p.apply(x[t[0]]), p.apply(x[t[1]]), p.apply(x[t[2]]));
    }
    const Placement& q = placements[element.placement + 1];
    const BodyEdge& e = input.topology.edges[element.index()];
    const Vector3d a = p.apply(x[e.a]), b = p.apply(x[e.b]), c = q.apply(x[e.b]), d = q.apply(x[e.a]);
    return std::min(test::meetsAt(from, way, a, b, c), test::meetsAt(from, way, a, c, d));
  }
  template <class Use>
  void forAll(const Use& use) const {
    for (std::uint32_t k = 0; k < placements.size(); ++k) {
      for (std::uint32_t f = 0; f < input.body.triangles.size(); ++f) use(SweptElement{f, k});
      if (k >= input.motion.steps()) continue;
      for (std::uint32_t e = 0; e < input.topology.edges.size(); ++e)
        use(SweptElement{e | SweptElement::kSidePatchBit, k});
    }
  }
};

TEST(SweepTree, NoPieceOnASegmentIsMissedAndNoneIsSeenTwice) {
  std::size_t met = 0, seen = 0, all = 0;
  for (unsigned seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    RunContext run;
    const CheckedBody body = checkBody(randomBody(random), {}, run);
    Trajectory path = checkTrajectory(randomMotion(random)).trajectory;
    if (path.interpolation == Interpolation::None) path.interpolation = Interpolation::Linear;
    Eigen::AlignedBox3d box;
    for (const auto& v : body.mesh.vertices) box.extend(v);
    const double cell = box.diagonal().norm() / 20;
    const Motion motion = refineMotion(body.mesh, path, 0.3 * cell, run);
    if (motion.placements.size() * body.mesh.triangles.size() > 40000) continue;
    const BodyTopology topology = buildTopology(body.mesh);
    GridPlan grid;
    grid.cell = cell;
    grid.origin = Vector3d(-3, 2, 1);
    const SamplerInput input{body.mesh, topology, motion, grid};
    const Pieces pieces(input);
    const SweepTree tree(input, pieces.placements);
    std::uniform_int_distribution<std::size_t> anyPlace(0, pieces.placements.size() - 1),
        anyVertex(0, body.mesh.vertices.size() - 1);
    std::normal_distribution<double> off;
    for (int n = 0; n < 40; ++n) {
      const Vector3d from = pieces.placements[anyPlace(random)].apply(
                                body.mesh.vertices[anyVertex(random)]) +
                            0.3 * Vector3d(off(random), off(random), off(random)),
                     way(off(random), off(random), off(random));
      std::set<Key> found;
      double reach = 2;
      tree.along(from, way, reach, [&](const SweptElement& e) {
        EXPECT_TRUE(found.emplace(e.code, e.placement).second);
      });
      double first = 2;
      pieces.forAll([&](const SweptElement& e) {
        ++all;
        const double at = pieces.meetsAt(e, from, way);
        if (at > 1) return;
        ++met;
        first = std::min(first, at);
        EXPECT_TRUE(found.count({e.code, e.placement})) << e.code << " " << e.placement;
      });
      seen += found.size();
      // A search that ends at its first hit finds the same one.
      reach = 2;
      tree.along(from, way, reach, [&](const SweptElement& e) {
        reach = std::min(reach, pieces.meetsAt(e, from, way));
      });
      EXPECT_EQ(reach, first);
    }
  }
  EXPECT_GT(met, 1000u);
  EXPECT_LT(8 * seen, all) << "most pieces are left out";
}

}  // namespace
}  // namespace swept::test
