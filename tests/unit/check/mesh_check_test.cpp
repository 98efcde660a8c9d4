// The mesh check finds planted faults of every kind.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "check/mesh_check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <random>

#include "base/checkpoint_hook.h"
#include "check/mesh_topology.h"
#include "geometry/self_intersections.h"
#include "geometry/triangle_pairs.h"
#include "support/shapes.h"
#include "swept/compute.h"

namespace swept::test {
namespace {

MeshCheck check(const TriMesh& mesh, std::optional<int> threads = {}) {
  RunContext run;
  run.threads = threads;
  return checkMesh(mesh, run);
}

TriMesh unitBox() { return makeBox({0, 0, 0}, {1, 1, 1}); }

/// Counts intersecting pairs by a test of every pair, without a tree and without the rule for fans.
std::int64_t bruteForce(const TriMesh& mesh) {
  std::int64_t count = 0;
  const auto n = static_cast<std::int64_t>(mesh.triangles.size());
  for (std::int64_t i = 0; i < n; ++i) {
    for (std::int64_t j = i + 1; j < n; ++j) count += trianglesIntersect(mesh, i, j);
  }
  return count;
}

TEST(MeshCheck, GoodBodiesPass) {
  for (const TriMesh& mesh : {unitBox(), makeBall({1, 2, 3}, 4, 3), makeCylinder(2, -1, 5, 40),
                              makeTorus(5, 1, 40, 20), makeSquareRing(3, 2, 0, 1)}) {
    const MeshCheck found = check(mesh);
    EXPECT_TRUE(found.passes());
    EXPECT_EQ(found.selfIntersections, 0);
    EXPECT_EQ(found.shells, 1);
    EXPECT_EQ(found.unusedVertices, 0);
    EXPECT_NEAR(found.volume, signedVolume(mesh), 1e-9);
    EXPECT_NEAR(found.area, surfaceArea(mesh), 1e-9);
  }
  EXPECT_NEAR(check(unitBox()).volume, 1, 1e-15);
  EXPECT_NEAR(check(unitBox()).area, 6, 1e-14);
}

TEST(MeshCheck, EmptyMeshDoesNotPass) { EXPECT_FALSE(check({}).passes()); }

TEST(MeshCheck, OpenEdge) {
  TriMesh mesh = unitBox();
  mesh.triangles.pop_back();
  const MeshCheck found = check(mesh);
  EXPECT_EQ(found.openEdges, 3);
  EXPECT_FALSE(found.closed);
  EXPECT_FALSE(found.passes());
}

TEST(MeshCheck, NonManifoldEdge) {
  // Two boxes that share the edge (1, 1, 0)-(1, 1, 1).
  TriMesh mesh = unitBox();
  const TriMesh other = makeBox({1, 1, 0}, {2, 2, 1});
  append(mesh, other);
  for (auto& t : mesh.triangles) {
    for (auto& v : t) v = v == 8 ? 3 : (v == 12 ? 7 : v);
  }
  const MeshCheck found = check(mesh);
  EXPECT_EQ(found.nonManifoldEdges, 1);
  EXPECT_TRUE(found.closed);
  EXPECT_FALSE(found.manifold);
  EXPECT_FALSE(found.passes());
  EXPECT_EQ(found.unusedVertices, 2);
}

TEST(MeshCheck, NonManifoldVertex) {
  // Bow tie: two boxes that share a corner.
  TriMesh mesh = unitBox();
  append(mesh, makeBox({1, 1, 1}, {2, 2, 2}));
  for (auto& t : mesh.triangles) {
    for (auto& v : t) v = v == 8 ? 7 : v;
  }
  const MeshCheck found = check(mesh);
  EXPECT_EQ(found.nonManifoldEdges, 0);
  EXPECT_EQ(found.nonManifoldVertices, 1);
  EXPECT_TRUE(found.closed);
  EXPECT_FALSE(found.manifold);
  EXPECT_EQ(found.selfIntersections, 0);
  EXPECT_FALSE(found.passes());
}

TEST(MeshCheck, FlippedTriangle) {
  TriMesh mesh = unitBox();
  std::swap(mesh.triangles[4][0], mesh.triangles[4][1]);
  const MeshCheck found = check(mesh);
  EXPECT_EQ(found.misorientedEdges, 3);
  EXPECT_FALSE(found.oriented);
  EXPECT_FALSE(found.passes());
}

TEST(MeshCheck, InvertedShell) {
  const MeshCheck found = check(inverted(unitBox()));
  EXPECT_EQ(found.misorientedEdges, 0);
  EXPECT_FALSE(found.oriented);
  EXPECT_NEAR(found.volume, -1, 1e-15);
  // One inverted shell among several.
  TriMesh two = unitBox();
  append(two, inverted(makeBox({3, 0, 0}, {4, 1, 1})));
  EXPECT_FALSE(check(two).oriented);
  EXPECT_EQ(check(two).shells, 2);
}

TEST(MeshCheck, ShellsInShells) {
  const TriMesh outer = makeBox({0, 0, 0}, {9, 9, 9});
  const TriMesh inner = makeBox({1, 1, 1}, {8, 8, 8});
  const TriMesh core = makeBox({2, 2, 2}, {3, 3, 3});
  TriMesh cavity = outer;
  append(cavity, inverted(inner));
  EXPECT_TRUE(check(cavity).passes());
  append(cavity, core);
  EXPECT_TRUE(check(cavity).passes());
  TriMesh wrong = outer;
  append(wrong, inner);
  EXPECT_FALSE(check(wrong).oriented);
  TriMesh wrongCore = outer;
  append(wrongCore, inverted(inner));
  append(wrongCore, inverted(core));
  EXPECT_FALSE(check(wrongCore).oriented);
  // Many bodies side by side, each with a cavity; one cavity has the wrong orientation.
  TriMesh many;
  for (int i = 0; i < 20; ++i) {
    append(many, transformed(outer, placement({0, 0, 1}, 0, {10.0 * i, 0, 0})));
    append(many, transformed(inverted(inner), placement({0, 0, 1}, 0, {10.0 * i, 0, 0})));
  }
  EXPECT_TRUE(check(many).passes());
  EXPECT_EQ(check(many).shells, 40);
  for (std::size_t t = 12 * 21; t < 12 * 22; ++t)
    std::swap(many.triangles[t][0], many.triangles[t][1]);
  EXPECT_FALSE(check(many).oriented);
}

TEST(MeshCheck, NotANumber) {
  TriMesh mesh = unitBox();
  mesh.vertices[2].z() = std::numeric_limits<double>::quiet_NaN();
  const MeshCheck found = check(mesh);
  EXPECT_FALSE(found.finite);
  EXPECT_FALSE(found.passes());
  EXPECT_FALSE(found.selfIntersections.has_value());
}

TEST(MeshCheck, BadIndexIsRefused) {
  TriMesh mesh = unitBox();
  mesh.triangles[3][1] = 99;
  RunContext run;
  EXPECT_THROW(checkMesh(mesh, run), Error);
}

TEST(MeshCheck, DegenerateTriangles) {
  TriMesh mesh = unitBox();
  mesh.triangles.push_back({0, 1, 0});
  EXPECT_EQ(check(mesh).degenerateTriangles, 1);
  // Three corners exactly on a line, with coordinates that are not round numbers.
  TriMesh line = unitBox();
  line.vertices.push_back({0.1, 0.2, 0.3});
  line.vertices.push_back({0.2, 0.4, 0.6});
  line.vertices.push_back({0.4, 0.8, 1.2});
  line.triangles.push_back({8, 9, 10});
  EXPECT_EQ(check(line).degenerateTriangles, 1);
  line.vertices[9].x() = std::nextafter(0.2, 1);  // off the line by one bit
  EXPECT_EQ(check(line).degenerateTriangles, 0);
}

TEST(MeshCheck, UnusedVertices) {
  TriMesh mesh = unitBox();
  mesh.vertices.push_back({7, 7, 7});
  EXPECT_EQ(check(mesh).unusedVertices, 1);
}

TEST(SelfIntersections, CrossingTriangles) {
  TriMesh mesh = unitBox();
  append(mesh, makeBox({0.5, 0.25, 0.25}, {2, 0.75, 0.75}));
  const MeshCheck found = check(mesh);
  EXPECT_TRUE(found.passes());
  EXPECT_EQ(found.selfIntersections, bruteForce(mesh));
  EXPECT_GT(found.selfIntersections, 0);
  ASSERT_FALSE(found.firstIntersections.empty());
  const auto [a, b] = found.firstIntersections[0];
  EXPECT_LT(a, 12);
  EXPECT_GE(b, 12);
  EXPECT_TRUE(trianglesIntersect(mesh, a, b));
}

TEST(SelfIntersections, FoldedEdge) {
  TriMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0.4, 1, 0}, {0.6, 0.5, 0}};
  mesh.triangles = {{0, 1, 2}, {1, 0, 3}};
  EXPECT_EQ(check(mesh).selfIntersections,
            1);  // both triangles lie on one side of the edge, in one plane
  mesh.vertices[3].z() = 1e-300;
  EXPECT_EQ(check(mesh).selfIntersections, 0);  // there is a tiny angle between them
  mesh.vertices[3] = {0.6, -0.5, 0};
  EXPECT_EQ(check(mesh).selfIntersections, 0);
}

TEST(SelfIntersections, FoldedFan) {
  // A fan of six flat triangles; one outer vertex is moved so far that triangles overlap.
  TriMesh mesh;
  mesh.vertices.push_back({0, 0, 0});
  for (int i = 0; i < 6; ++i) {
    const double angle = 3.14159265358979 / 3 * i;
    mesh.vertices.emplace_back(std::cos(angle), std::sin(angle), 0);
  }
  for (std::int32_t i = 0; i < 6; ++i) mesh.triangles.push_back({0, 1 + i, 1 + (i + 1) % 6});
  EXPECT_EQ(check(mesh).selfIntersections, 0);
  mesh.vertices[2] = {std::cos(-0.4), std::sin(-0.4), 0};
  EXPECT_EQ(check(mesh).selfIntersections, bruteForce(mesh));
  EXPECT_GT(check(mesh).selfIntersections, 0);
  // Two vertices leave the plane, so that triangles pierce one another round the vertex.
  mesh.vertices[2] = {std::cos(-0.4), std::sin(-0.4), 0.2};
  mesh.vertices[1].z() = 0.3;
  EXPECT_EQ(check(mesh).selfIntersections, bruteForce(mesh));
}

TEST(SelfIntersections, FanThatGoesRoundTwice) {
  // All triangles of the fan turn the same way, but twice around: a simple test of the
  // orientation would miss it.
  TriMesh mesh;
  mesh.vertices.push_back({0, 0, 1});
  const int n = 14;
  for (int i = 0; i < n; ++i) {
    const double angle = 4 * 3.14159265358979 / n * i;
    mesh.vertices.emplace_back(std::cos(angle), std::sin(angle), 0.01 * (i % 2));
  }
  for (std::int32_t i = 0; i < n; ++i) mesh.triangles.push_back({0, 1 + i, 1 + (i + 1) % n});
  const std::int64_t expected = bruteForce(mesh);
  EXPECT_GT(expected, 0);
  EXPECT_EQ(check(mesh).selfIntersections, expected);
}

TEST(SelfIntersections, CoplanarOverlap) {
  TriMesh mesh;
  mesh.vertices = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 0}, {5, 1, 0},
                   {1, 5, 0}, {9, 9, 0}, {8, 9, 0}, {9, 8, 0}};
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}};
  EXPECT_EQ(check(mesh).selfIntersections, 1);
  // The second triangle lies inside the first, and the third touches it with a corner.
  mesh.vertices[3] = {0.5, 0.5, 0};
  mesh.vertices[4] = {1, 0.5, 0};
  mesh.vertices[5] = {0.5, 1, 0};
  mesh.vertices[6] = {2, 2, 0};
  EXPECT_EQ(check(mesh).selfIntersections, 2);
}

TEST(SelfIntersections, TouchingCounts) {
  // A corner lies exactly in the interior of the other triangle; then it is moved one bit above.
  TriMesh mesh;
  mesh.vertices = {{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {1, 1, 0}, {1, 1, 2}, {2, 1, 2}};
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
  EXPECT_EQ(check(mesh).selfIntersections, 1);
  mesh.vertices[3].z() = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(check(mesh).selfIntersections, 0);
}

TEST(SelfIntersections, SameTriangleTwice) {
  TriMesh mesh = unitBox();
  mesh.triangles.push_back(mesh.triangles[5]);
  mesh.triangles.push_back({mesh.triangles[0][1], mesh.triangles[0][0], mesh.triangles[0][2]});
  EXPECT_EQ(check(mesh).selfIntersections, bruteForce(mesh));
  EXPECT_GE(check(mesh).selfIntersections, 2);
}

TEST(SelfIntersections, AgreesWithAllPairsOnRandomMeshes) {
  std::mt19937 random(20240607);
  std::uniform_real_distribution<double> jitter(-1, 1);
  std::int64_t total = 0;
  for (int round = 0; round < 60; ++round) {
    // The meshes range from hardly disturbed to tangled. In every third one, coordinates are
    // rounded to a coarse lattice, so many are equal.
    TriMesh mesh = round % 2 == 0 ? makeBall({0, 0, 0}, 1, 2) : makeTorus(2, 0.7, 16, 9);
    const double amount = 0.02 * (round / 3);
    for (auto& v : mesh.vertices) {
      v += amount * Eigen::Vector3d(jitter(random), jitter(random), jitter(random));
      if (round % 3 == 0) v = (v * 4).array().round() / 4;
    }
    std::int64_t expected = 0;
    const auto n = static_cast<std::int64_t>(mesh.triangles.size());
    auto flat = [&](std::int64_t t) {
      const auto& tri = mesh.triangles[t];
      const Eigen::Vector3d u = mesh.vertices[tri[1]] - mesh.vertices[tri[0]];
      return u.cross(mesh.vertices[tri[2]] - mesh.vertices[tri[0]]).norm() < 1e-12;
    };
    for (std::int64_t i = 0; i < n; ++i) {
      for (std::int64_t j = i + 1; j < n; ++j) {
        expected += !flat(i) && !flat(j) && trianglesIntersect(mesh, i, j);
      }
    }
    total += expected;
    EXPECT_EQ(check(mesh).selfIntersections, expected) << "round " << round;
    RunContext run;
    EXPECT_EQ(findSelfIntersections(mesh, {}, run).count, expected) << "round " << round;
  }
  EXPECT_GT(total, 1000);
}

// Large fans are searched with a tree. Corners that are moved, some to the other side of the fan,
// make triangles that intersect.
TEST(SelfIntersections, LargeFansAgreeWithAllPairs) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> jitter(-1.5, 1.5);
  std::int64_t total = 0;
  for (int round = 0; round < 24; ++round) {
    constexpr std::int32_t kSides = 200;
    const double height = round % 2 == 0 ? 0 : 0.4;
    TriMesh mesh;
    mesh.vertices = {{1, 2, 3}};
    for (std::int32_t n = 1; n <= kSides; ++n) {
      const double angle = 2 * M_PI * n / kSides;
      mesh.vertices.push_back(mesh.vertices[0] +
                              Eigen::Vector3d(std::cos(angle), std::sin(angle), height));
      mesh.triangles.push_back({0, n, n % kSides + 1});
    }
    RunContext run;
    EXPECT_EQ(findSelfIntersections(mesh, {}, run).count, 0);
    for (int n = 0; n < 1 + round / 4; ++n) {
      Eigen::Vector3d& corner = mesh.vertices[1 + random() % kSides];
      const double up = round % 3 == 0 ? 0 : jitter(random);  // without it, a flat fan overlaps
      corner += Eigen::Vector3d(jitter(random), jitter(random), up);
    }
    const std::int64_t expected = bruteForce(mesh);
    total += expected;
    EXPECT_EQ(findSelfIntersections(mesh, {}, run).count, expected) << "round " << round;
  }
  EXPECT_GT(total, 500);
}

TEST(SelfIntersections, VeryUnevenSizes) {
  // A large box whose sides cut through a cloud of small balls.
  TriMesh mesh = makeBox({-100, -100, -100}, {100, 100, 0.013});
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-90, 90);
  for (int i = 0; i < 40; ++i) {
    append(mesh, makeBall({place(random), place(random), i % 2 == 0 ? 0.0 : 5.0}, 0.3, 1));
  }
  EXPECT_EQ(check(mesh).selfIntersections, bruteForce(mesh));
}

TEST(MeshCheck, SameAnswerForAnyNumberOfThreads) {
  TriMesh mesh = makeBall({0, 0, 0}, 1, 5);
  append(mesh, makeBall({0.3, 0.1, 0.2}, 1, 5));
  const MeshCheck one = check(mesh, 1);
  EXPECT_GT(one.selfIntersections, 32);
  for (const int threads : {2, 3, 8}) {
    const MeshCheck other = check(mesh, threads);
    EXPECT_EQ(one.selfIntersections, other.selfIntersections);
    EXPECT_EQ(one.firstIntersections, other.firstIntersections);
    EXPECT_EQ(one.volume, other.volume);  // to the last bit
    EXPECT_EQ(one.area, other.area);
  }
}

TEST(MeshCheck, CanLeaveOutSelfIntersections) {
  RunContext run;
  EXPECT_FALSE(checkMesh(unitBox(), false, run).selfIntersections.has_value());
  EXPECT_TRUE(checkMesh(unitBox(), false, run).passes());
}

TEST(MeshCheck, CancelsAtEveryCheckpoint) {
  TriMesh mesh = makeBall({0, 0, 0}, 1, 4);
  RunContext whole;
  whole.threads = 1;
  checkMesh(mesh, whole);
  ASSERT_GT(CheckpointHook::passed(whole), 5u);
  for (std::uint64_t n = 1; n <= CheckpointHook::passed(whole); ++n) {
    RunContext run;
    run.threads = 1;
    CheckpointHook::cancelAt(run, n);
    try {
      checkMesh(mesh, run);
      FAIL() << "not cancelled at " << n;
    } catch (const Error& error) {
      EXPECT_EQ(error.status(), Status::Cancelled);
    }
  }
}

}  // namespace
}  // namespace swept::test
