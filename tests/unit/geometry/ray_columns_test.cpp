// Winding numbers from rays, compared with the sum of solid angles (Van Oosterom and Strackee
// 1983).
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/ray_columns.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "geometry/triangle_distance.h"
#include "support/random_numbers.h"
#include "support/shapes.h"

namespace swept::test {
namespace {

using Eigen::Vector3d;

double bySolidAngles(const TriMesh& mesh, const Vector3d& p) {
  double angle = 0;
  for (const auto& t : mesh.triangles) {
    const Vector3d a = mesh.vertices[t[0]] - p, b = mesh.vertices[t[1]] - p,
                   c = mesh.vertices[t[2]] - p;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    angle += 2 * std::atan2(a.dot(b.cross(c)),
                            la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return angle / (4 * M_PI);
}

/// Returns a mesh of a solid, a cavity, an overlap, and a ball with inward triangles.
TriMesh nested() {
  TriMesh mesh = makeBox(Vector3d::Constant(-10), Vector3d::Constant(10));
  append(mesh, inverted(makeBox(Vector3d::Constant(-4), Vector3d::Constant(4))));
  append(mesh, makeBall(Vector3d(9, 0, 0), 4, 2));
  append(mesh, inverted(makeBall(Vector3d(30, 0, 0), 4, 2)));
  append(mesh, makeBox({-20, -20, -20}, {-19.9, 20, -19.8}));
  return mesh;
}

bool isOnSurface(const TriMesh& mesh, const Vector3d& p) {
  return std::any_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const auto& t) {
    return squaredDistance(p, mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]) <
           1e-18;
  });
}

TEST(RayColumns, WindingAgreesWithSolidAngles) {
  Random random(23);
  const Eigen::Isometry3d turn = placement({1, 2, 3}, 40, {5, -7, 1});
  int decidedCount = 0, inside = 0;
  for (const TriMesh& mesh :
       {nested(), soup(nested()), transformed(nested(), turn), makeTorus(10, 3, 60, 30)}) {
    const RayColumns rays(mesh);
    for (int n = 0; n < 1500; ++n) {
      const Vector3d p =
          // Rays from rounded points hit edges.
          n % 2 == 0 ? random.point(25) : Vector3d(random.point(14).array().round());
      if (isOnSurface(mesh, p)) continue;
      const double angles = bySolidAngles(mesh, p);
      ASSERT_NEAR(angles, std::round(angles), 1e-6);
      ++decidedCount;
      inside += angles > 0.5;
      EXPECT_EQ(rays.winding(p), std::lround(angles)) << p.transpose();
    }
  }
  EXPECT_GT(decidedCount, 4000);
  EXPECT_GT(inside, 300);
}

TEST(RayColumns, CrossingsRiseAndTellTheSameWinding) {
  Random random(29);
  const TriMesh mesh = nested();
  const RayColumns rays(mesh);
  std::vector<RayColumns::Crossing> line;
  for (int n = 0; n < 1000; ++n) {
    const Vector3d p = random.point(12);
    rays.crossings(p.y(), p.z(), line);
    int winding = 0, sum = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
      EXPECT_LE(line[i > 0 ? i - 1 : 0].x, line[i].x);
      if (line[i].x > p.x()) winding -= line[i].direction;
      sum += line[i].direction;
    }
    EXPECT_EQ(sum, 0);
    EXPECT_EQ(winding, rays.winding(p));
  }
}

TEST(RayColumns, ColumnsOfAPartAnswerForThatPart) {
  Random random(37);
  const TriMesh mesh = makeTorus(10, 3, 60, 30);
  const RayColumns all(mesh), part(mesh, {-13, 4, -1}, {13, 8, 1});
  std::vector<RayColumns::Crossing> a, b;
  for (int n = 0; n < 500; ++n) {
    const double y = random.number(4, 8), z = random.number(-1, 1);
    all.crossings(y, z, a);
    part.crossings(y, z, b);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_EQ(a[i].x, b[i].x);
      EXPECT_EQ(a[i].triangle, b[i].triangle);
    }
  }
}

TEST(RayColumns, LongTrianglesStandInTheColumnsThatTheyCover) {
  Random random(41);
  // The cylinder is slanted, and far from the origin.
  const TriMesh mesh =
      transformed(makeCylinder(1, 0, 40, 1000), placement({1, 2, 3}, 70, {5e4, -7e4, 1e4}));
  const RayColumns rays(mesh);
  // The box of each triangle covers hundreds of columns.
  EXPECT_LT(rays.entries(), 60 * mesh.triangles.size());

  // A mesh of one triangle has one column.
  std::vector<TriMesh> alone(mesh.triangles.size());
  std::vector<RayColumns> raysAlone;
  for (std::size_t t = 0; t < alone.size(); ++t) {
    for (const std::int32_t v : mesh.triangles[t]) alone[t].vertices.push_back(mesh.vertices[v]);
    alone[t].triangles = {{0, 1, 2}};
    raysAlone.emplace_back(alone[t], rays.low(), rays.high());
  }
  std::vector<RayColumns::Crossing> line, one;
  std::size_t crossed = 0;
  for (std::size_t n = 0; n < 300; ++n) {
    const Vector3d along = random.point(0.5).array() + 0.5;
    const Vector3d p = n % 3 == 0  // also corners of triangles
                           ? mesh.vertices[7 * n % mesh.vertices.size()]
                           : Vector3d(rays.low() + along.cwiseProduct(rays.high() - rays.low()));
    rays.crossings(p.y(), p.z(), line);
    std::set<std::int32_t> found, expected;
    for (const auto& crossing : line) found.insert(crossing.triangle);
    for (std::size_t t = 0; t < alone.size(); ++t) {
      raysAlone[t].crossings(p.y(), p.z(), one);
      if (!one.empty()) expected.insert(static_cast<std::int32_t>(t));
    }
    EXPECT_EQ(found, expected) << p.transpose();
    crossed += line.size();
  }
  EXPECT_GT(crossed, 200u);
}

}  // namespace
}  // namespace swept::test
