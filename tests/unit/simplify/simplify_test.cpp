// Simplification: deviation, topology, creases, a second cut of the kept surface.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>

#include "geometry/nearest_triangle.h"
#include "geometry/quadric.h"
#include "simplify/vertex_tree.h"
#include "support/shapes.h"
#include "swept/compute.h"

namespace swept::test {
namespace {

Result sweep(const TriMesh& body, const std::vector<Pose>& poses, int resolution,
             double tolerance) {
  Trajectory trajectory;
  trajectory.poses = poses;
  Options options;
  options.resolution = resolution;
  options.tolerance = tolerance;
  RunContext run;
  Result result = compute(body, trajectory, options, run);
  EXPECT_EQ(result.report.status, Status::Ok) << result.report.message;
  return result;
}

/// Distance of a point from a mesh over all triangles: a path without any tree.
double distanceTo(const TriMesh& mesh, const Eigen::Vector3d& p) {
  double best = 1e300;
  for (const auto& t : mesh.triangles) {
    best = std::min(
        best, squaredDistance(p, mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]));
  }
  return std::sqrt(best);
}

/// Largest distance of points of `from` (corners and points within the triangles) from `to`.
double oneSided(const TriMesh& from, const TriMesh& to, int points) {
  double largest = 0;
  const std::size_t step = std::max<std::size_t>(1, from.triangles.size() / points);
  for (std::size_t n = 0; n < from.triangles.size(); n += step) {
    const auto& t = from.triangles[n];
    const auto &a = from.vertices[t[0]], &b = from.vertices[t[1]], &c = from.vertices[t[2]];
    for (const auto& [u, v] :
         {std::pair{0.0, 0.0}, {0.2, 0.3}, {0.6, 0.2}, {0.1, 0.8}, {0.5, 0.0}}) {
      largest = std::max(largest, distanceTo(to, a + u * (b - a) + v * (c - a)));
    }
  }
  return largest;
}

const std::vector<Pose> kTurned = {poseOf(0, placement({1, 2, 3}, 25, {0, 0, 0}))};

std::vector<Pose> bend() {
  return {poseOf(0, placement({0, 0, 1}, 0, {0, 0, 0})),
          poseOf(1, placement({0, 1, 1}, 40, {20, 5, 3}))};
}

}  // namespace

TEST(Simplify, BoxKeepsItsTwelveTriangles) {
  const TriMesh body = makeBox({0, 0, 0}, {10, 7, 4});
  const Result result = sweep(body, kTurned, 64, 0.02);
  EXPECT_TRUE(result.report.check.passes());
  EXPECT_EQ(result.report.check.selfIntersections, 0);
  EXPECT_EQ(result.mesh.triangles.size(), 12u);
  EXPECT_EQ(result.featureEdges.size(), 12u);
  EXPECT_LE(result.report.simplificationDeviation, 0.02);
  EXPECT_NEAR(result.report.check.volume, 280, 280 * 0.002);
}

TEST(Simplify, MeasuredDeviationStaysBelowTheTolerance) {
  for (const double tolerance : {0.03, 0.3}) {
    const TriMesh body = makeCylinder(4, -6, 6, 48);
    const Result plain = sweep(body, bend(), 48, 0), result = sweep(body, bend(), 48, tolerance);
    EXPECT_TRUE(result.report.check.passes());
    EXPECT_EQ(result.report.check.selfIntersections, 0);
    EXPECT_GT(result.report.simplificationDeviation, 0.3 * tolerance);
    EXPECT_LE(result.report.simplificationDeviation, tolerance);
    EXPECT_LE(oneSided(plain.mesh, result.mesh, 1500), tolerance);
    EXPECT_LE(oneSided(result.mesh, plain.mesh, 500), tolerance);
    EXPECT_LT(result.mesh.triangles.size(), plain.mesh.triangles.size() / 4);
    EXPECT_EQ(result.contactTime.size(), result.mesh.vertices.size());
  }
}

TEST(Simplify, SecondCutEqualsADirectOne) {
  const TriMesh body = makeTorus(8, 3, 48, 24);
  Result kept = sweep(body, bend(), 40, 0.4);
  const Result direct = sweep(body, bend(), 40, 0.1), plain = sweep(body, bend(), 40, 0);
  RunContext run;
  recut(kept, 0.1, run);
  EXPECT_EQ(kept.mesh.vertices, direct.mesh.vertices);
  EXPECT_EQ(kept.mesh.triangles, direct.mesh.triangles);
  recut(kept, 0, run);
  EXPECT_EQ(kept.mesh.vertices, plain.mesh.vertices);
  EXPECT_EQ(kept.mesh.triangles, plain.mesh.triangles);
  EXPECT_EQ(kept.report.simplificationDeviation, 0);
}

TEST(Simplify, SameBytesForAnyNumberOfThreads) {
  const TriMesh body = makeTorus(8, 3, 48, 24);
  Trajectory trajectory;
  trajectory.poses = bend();
  Options options;
  options.resolution = 40;
  options.tolerance = 0.1;
  std::vector<TriMesh> meshes;
  for (const int threads : {1, 2, 5}) {
    RunContext run;
    run.threads = threads;
    meshes.push_back(compute(body, trajectory, options, run).mesh);
  }
  for (const TriMesh& mesh : meshes) {
    EXPECT_EQ(mesh.vertices, meshes[0].vertices);
    EXPECT_EQ(mesh.triangles, meshes[0].triangles);
  }
}

TEST(Simplify, RecutNeedsAKeptSurface) {
  Result result = sweep(makeBox({0, 0, 0}, {1, 1, 1}), kTurned, 16, 0);
  RunContext run;
  EXPECT_THROW(recut(result, 0.1, run), Error);
}

/// A torus in a grid of few cells: patches that are rings or wrap round a handle are no discs.
TEST(VertexTree, CutKeepsTheHandle) {
  const TriMesh torus = makeTorus(6, 2, 60, 30);
  RunContext run;
  VertexTree tree;
  tree.build(torus.vertices, torus.triangles, run);
  std::vector<std::uint8_t> blocked(tree.nodes().size(), 0);
  const TreeCut cut = cutTree(tree, torus.triangles, 1e9, blocked, run);
  TriMesh mesh;
  for (const std::int32_t node : cut.nodeOf) mesh.vertices.push_back(tree.nodes()[node].position);
  mesh.triangles = cut.triangles;
  const MeshCheck check = checkMesh(mesh, run);
  EXPECT_TRUE(check.closed && check.manifold);
  const auto v = static_cast<std::int64_t>(mesh.vertices.size());
  const auto f = static_cast<std::int64_t>(mesh.triangles.size());
  EXPECT_EQ(v - 3 * f / 2 + f, 0);  // Euler characteristic of a torus
  EXPECT_LT(f, 1800);
}

TEST(Quadric, RankCountsTheDirectionsThatAreFixed) {
  const Eigen::Vector3d x(1, 0, 0), y(0, 1, 0), z(0, 0, 1), p(2, 3, 4), about(0, 0, 0);
  Quadric q;
  int rank = 0;
  q.addPlane(x, p, 1);
  EXPECT_TRUE(q.minimise(about, 0.03, rank).isApprox(Eigen::Vector3d(2, 0, 0)));
  EXPECT_EQ(rank, 1);
  q.addPlane(y, p, 1);
  EXPECT_TRUE(q.minimise(about, 0.03, rank).isApprox(Eigen::Vector3d(2, 3, 0)));
  EXPECT_EQ(rank, 2);
  q.addPlane(z, p, 1);
  EXPECT_TRUE(q.minimise(about, 0.03, rank).isApprox(p));
  EXPECT_EQ(rank, 3);
  EXPECT_NEAR(q.error(p), 0, 1e-12);
}

}  // namespace swept::test
