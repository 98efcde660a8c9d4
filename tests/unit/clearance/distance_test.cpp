// Distance of meshes at a pose, and the inside test, compared with brute force and with FCL.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include "clearance/pair_search.h"
#include "clearance/stamping.h"
#include "support/random_numbers.h"
#include "support/sampled.h"
#include "support/shapes.h"

namespace swept::clearance {
namespace {

using Eigen::Vector3d;
using namespace swept::test;

Eigen::Isometry3d randomPose(Random& random, double size) {
  const Vector3d axis = random.point(1) + Vector3d(0, 0, 1e-3);
  const double degrees = random.number(-180, 180);
  return placement(axis, degrees, random.point(size));
}

TEST(Part, InsideOfNestedAndOverlappingShells) {
  TriMesh mesh = makeBox(Vector3d::Constant(-10), Vector3d::Constant(10));
  append(mesh, inverted(makeBox(Vector3d::Constant(-4), Vector3d::Constant(4))));  // a cavity
  append(mesh, makeBall(Vector3d(9, 0, 0), 4, 2));  // overlaps the box
  for (const TriMesh& m : {mesh, soup(mesh)}) {
    const Part tree(m, "the mesh");
    EXPECT_TRUE(tree.closed());
    EXPECT_EQ(tree.pieces().size(), 3u);
    EXPECT_FALSE(tree.inside({0, 0, 0}));
    EXPECT_TRUE(tree.inside({5, 5, 5}));
    EXPECT_TRUE(tree.inside({9.5, 0, 0}));
    EXPECT_TRUE(tree.inside({11, 0, 0}));
    EXPECT_FALSE(tree.inside({9.9, 9.9, 10.1}));
    EXPECT_NEAR(tree.depth({0, 0, 7}).depth, 3, 1e-12);
    EXPECT_NEAR(tree.depth({0, 0, 0}).depth, -4, 1e-12);
    EXPECT_NEAR(tree.depth({0, 0, 12}).depth, -2, 1e-12);
  }
  TriMesh open = mesh;
  open.triangles.pop_back();
  EXPECT_FALSE(Part(open, "the mesh").closed());
  EXPECT_FALSE(Part(open, "the mesh").inside({5, 5, 5}));
}

TEST(Part, InsideHoldsForEveryLatticePointOfABox) {
  // Many rays of the inside test pass through edges and diagonals of faces.
  const Part tree(makeBox(Vector3d::Zero(), Vector3d::Constant(8)), "the box");
  for (int i = -1; i <= 9; ++i)
    for (int j = -1; j <= 9; ++j)
      for (int k = -1; k <= 9; ++k) {
        const auto within = [](int x) { return x > 0 && x < 8; };
        const auto onBorder = [](int x) { return x == 0 || x == 8; };
        if (onBorder(i) || onBorder(j) || onBorder(k)) continue;
        EXPECT_EQ(tree.inside(Vector3d(i, j, k)), within(i) && within(j) && within(k));
      }
}

TEST(PairSearch, DistanceAgreesWithAllPairsAndWithFcl) {
  Random random(7);
  const TriMesh a = makeTorus(10, 3, 24, 12);
  TriMesh b = makeBall({0, 0, 0}, 4, 2);
  append(b, makeBox({6, 6, -20}, {7, 7, 20}));
  const Part treeA(a, "a");
  const Part treeB(b, "b");
  const PairSearch search(treeA, treeB);
  RunContext run;
  for (int k = 0; k < sampled(60, 12); ++k) {
    const Eigen::Isometry3d place = randomPose(random, 25);
    const PairDistance found = search.distanceAt(place.linear(), place.translation(), 1e300);
    double all = 1e300;
    for (const auto& s : a.triangles) {
      Triangle3d p;
      for (int i = 0; i < 3; ++i) p[i] = place * a.vertices[s[i]];
      for (const auto& t : b.triangles)
        all = std::min(
            all, nearestPoints(p, {b.vertices[t[0]], b.vertices[t[1]], b.vertices[t[2]]}).squared);
    }
    EXPECT_NEAR(found.distance, std::sqrt(all), 1e-12);
    EXPECT_NEAR((found.onBody - found.onNeighbour).norm(), found.distance, 1e-12);
    const StampedMinimum fcl = stampEveryPose(a, {poseOf(0, place)}, b, run);
    EXPECT_NEAR(found.distance, fcl.distance, 1e-9);
    // With a bound below the distance, nothing is found; with a bound above, the same pair.
    if (found.distance > 0) {
      EXPECT_LT(
          search.distanceAt(place.linear(), place.translation(), 0.999 * found.distance).pair.body,
          0);
    }
  }
}

TEST(MotionBound, NoPointAdvancesFartherThanSaid) {
  Random random(11);
  for (const Interpolation kind :
       {Interpolation::None, Interpolation::Linear, Interpolation::Screw}) {
    Trajectory trajectory{{}, kind};
    Eigen::Isometry3d place = randomPose(random, 50);
    for (int i = 0; i < 40; ++i) {
      trajectory.poses.push_back(poseOf(i, place));
      place = placement(random.point(1), random.number(0, i % 3 == 0 ? 90 : 4),
                        random.point(i % 2 ? 9 : 0.1)) *
              place;
    }
    const Vector3d centre(3, -2, 8);
    const Vector3d half(4, 7, 2);
    const MotionTree motion(trajectory, centre, half);
    std::vector<MotionNode> nodes{motion.root()};
    for (std::size_t next = 0; next < nodes.size() && nodes.size() < 3000; ++next) {
      const MotionNode node = nodes[next];
      const MotionBound bound = motion.bound(node);
      std::vector<std::int32_t> members;
      motion.listMembers(node, members);
      for (int k = 0; k < 20; ++k) {
        const std::int32_t m =
            members[static_cast<std::size_t>(random.number(0, 0.999) * double(members.size()))];
        const bool whole = node.cluster >= 0;
        double u = m;
        if (motion.isContinuous())
          u += whole ? random.number(0, 1) : random.number(node.from, node.to);
        const Pose pose = motion.poseAt(u);
        const Vector3d local =
            Vector3d(random.number(-1, 1), random.number(-1, 1), random.number(-1, 1));
        const Vector3d x = centre + half.cwiseProduct(local);
        const Vector3d moved = pose.rotation * x + pose.translation - (bound.R * x + bound.t);
        EXPECT_LE(moved.norm(), bound.reach + 1e-9);
        const Vector3d n = random.point(1).normalized();
        EXPECT_LE(n.dot(moved), bound.advance(n, x, Vector3d::Zero()) + 1e-9);
        const Vector3d part = 0.3 * half;
        const Vector3d partCentre = x - part.cwiseProduct(local);
        EXPECT_LE(n.dot(moved), bound.advance(n, partCentre, part) + 1e-9);
      }
      if (motion.splits(node) && nodes.size() < 2000) motion.split(node, nodes);
    }
  }
}

}  // namespace
}  // namespace swept::clearance
