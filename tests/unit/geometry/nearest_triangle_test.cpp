// The nearest triangle of a mesh, compared with a test of every triangle.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/nearest_triangle.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/random_numbers.h"
#include "support/shapes.h"

namespace swept::test {
namespace {

using Eigen::Vector3d;

double byLookingAtAll(const Vector3d& p, const TriMesh& mesh) {
  double best = HUGE_VAL;
  for (const auto& t : mesh.triangles) {
    best = std::min(
        best, squaredDistance(p, mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]));
  }
  return best;
}

std::vector<TriMesh> someMeshes(Random& random) {
  TriMesh mixed = makeBall({0, 0, 0}, 4, 3);
  append(mixed, makeBox({-20, -20, 6}, {20, 20, 7}));
  TriMesh cloud;  // crossing triangles, needles and points among them
  for (int t = 0; t < 700; ++t) {
    const Vector3d a = random.point(5);
    for (int k = 0; k < 3; ++k) {
      const double size = t % 7 == 0 ? 0 : t % 7 == 1 ? 8 : 0.5;
      cloud.vertices.push_back(a + random.point(size).cwiseProduct(Vector3d(1, 1, t % 3)));
    }
    cloud.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  TriMesh single = makeBox({0, 0, 0}, {1, 1, 1});
  single.triangles.resize(1);
  TriMesh far = makeTorus(10, 3, 24, 12);
  for (Vector3d& v : far.vertices) v += Vector3d(1e6, -3e6, 2e6);
  return {mixed, cloud, single, far};
}

TEST(NearestTriangle, AgreesWithAllTriangles) {
  Random random(17);
  for (const TriMesh& mesh : someMeshes(random)) {
    const NearestTriangle nearest(mesh.vertices, mesh.triangles);
    std::int32_t hint = -1;
    for (int n = 0; n < 500; ++n) {
      const Vector3d p = mesh.vertices[0] + random.point(n % 10 == 0 ? 1e5 : 12);
      const double all = byLookingAtAll(p, mesh);
      EXPECT_EQ(nearest.query(p, HUGE_VAL, 0), all);
      EXPECT_EQ(nearest.query(p, HUGE_VAL, 0, hint), all);
      const auto& t = mesh.triangles[static_cast<std::size_t>(hint)];
      EXPECT_EQ(squaredDistance(p, mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]),
                all);
    }
  }
}

TEST(NearestTriangle, KeepsToItsBounds) {
  Random random(19);
  for (const TriMesh& mesh : someMeshes(random)) {
    const NearestTriangle nearest(mesh.vertices, mesh.triangles);
    for (int n = 0; n < 500; ++n) {
      const Vector3d p = mesh.vertices[0] + random.point(12);
      const double all = byLookingAtAll(p, mesh), limit = random.number(0, 60);
      EXPECT_EQ(nearest.query(p, limit, 0), std::min(all, limit));
      // Both bounds equal the limit: the query only finds whether a triangle is nearer than the
      // limit.
      EXPECT_EQ(nearest.query(p, limit, limit) < limit, all < limit);
      const double enough = random.number(0, 60), found = nearest.query(p, HUGE_VAL, enough);
      EXPECT_GE(found, all);
      if (all > enough) {
        EXPECT_EQ(found, all);
      } else {
        EXPECT_LE(found, enough);
      }
    }
  }
}

TEST(NearestTriangle, WalksFindWhatSearchesFind) {
  Random random(29);
  for (const TriMesh& mesh : someMeshes(random)) {
    for (const auto walks : {NearestTriangle::Walks::No, NearestTriangle::Walks::Yes}) {
      const NearestTriangle nearest(mesh.vertices, mesh.triangles, walks);
      std::int32_t hint = -1;
      Vector3d p = mesh.vertices[0];
      int near = 0;
      for (int n = 0; n < 500; ++n) {
        // The points follow a path of small steps, with occasional jumps.
        p = n % 50 == 0 ? Vector3d(mesh.vertices[0] + random.point(12))
                        : Vector3d(p + random.point(0.5));
        const double all = byLookingAtAll(p, mesh);
        const double limit = n % 7 == 0 ? 0 : random.number(0, 3 * all);
        const bool expected = all <= limit;
        EXPECT_EQ(nearest.isNear(p, limit, hint), expected) << n;
        near += expected;
        if (!expected) continue;
        const auto& t = mesh.triangles[static_cast<std::size_t>(hint)];
        EXPECT_LE(squaredDistance(p, mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]),
                  limit);
      }
      EXPECT_GT(near, 100);
      EXPECT_LT(near, 450);
    }
  }
}

TEST(NearestTriangle, FindsNothingInAnEmptyMesh) {
  const TriMesh empty;
  EXPECT_EQ(NearestTriangle(empty.vertices, empty.triangles).query({0, 0, 0}, 9, 0), 9);
}

}  // namespace
}  // namespace swept::test
