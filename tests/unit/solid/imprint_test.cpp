// Meshes that are cut along paths, and needles that are replaced.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/mesh/imprint.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "solid/mesh/flip_needles.h"
#include "support/shapes.h"

namespace swept::step {
namespace {

using Eigen::Vector3d;

constexpr double kRadius = 10, kSnap = 0.02;

HalfEdgeMesh ball() {
  RunContext run;
  return buildHalfEdges(test::makeBall(Vector3d::Zero(), kRadius, 4), run);
}

Vector3d onCircle(double angle, double height) {
  const double radius = std::sqrt(kRadius * kRadius - height * height);
  return {radius * std::cos(angle), radius * std::sin(angle), height};
}

// Inserts a circle of latitude. Returns its vertices, the first one also at the end.
std::vector<std::int32_t> addCircle(Imprint& imprint, double height, int points, int owner) {
  std::vector<std::int32_t> corners;
  for (int i = 0; i < points; ++i)
    corners.push_back(imprint.insert(onCircle(2 * M_PI * i / points, height)).value());
  std::vector<std::int32_t> path{corners.front()};
  for (int i = 0; i < points; ++i) {
    const auto part = imprint.connect(corners[i], corners[(i + 1) % points], owner);
    EXPECT_FALSE(part.empty()) << i;
    if (part.empty()) return {};
    path.insert(path.end(), part.begin() + 1, part.end());
  }
  return path;
}

TEST(Imprint, ACircleSeparatesTwoRegionsOfABall) {
  const HalfEdgeMesh mesh = ball();
  Imprint imprint(mesh, kSnap);
  const double height = 3.3;
  const auto path = addCircle(imprint, height, 40, 7);
  ASSERT_FALSE(path.empty());
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    EXPECT_GE(imprint.triangleBeside(path[i], path[i + 1]), 0);
    EXPECT_EQ(imprint.ownerOf(path[i + 1], path[i]), 7);
  }
  const std::vector<std::int32_t> region = imprint.regions();
  EXPECT_EQ(std::set<std::int32_t>(region.begin(), region.end()).size(), 2u);
  // Eastward, the north is to the left.
  const std::int32_t north = region[imprint.triangleBeside(path[0], path[1])];
  const std::int32_t south = region[imprint.triangleBeside(path[1], path[0])];
  EXPECT_NE(north, south);
  for (std::size_t t = 0; t < region.size(); ++t) {
    double z = 0;
    for (const std::int32_t v : imprint.triangles()[t]) z += imprint.points()[v].z() / 3;
    if (std::abs(z - height) > 0.1) {
      EXPECT_EQ(region[t], z > height ? north : south) << z;
    }
  }
  RunContext run;
  EXPECT_NO_THROW(buildHalfEdges({imprint.points(), imprint.triangles()}, run));
}

TEST(Imprint, PointsHaveTheGivenPositions) {
  const HalfEdgeMesh mesh = ball();
  Imprint imprint(mesh, kSnap);
  const Vector3d p(4.2, -1.1, std::sqrt(100 - 4.2 * 4.2 - 1.1 * 1.1));
  const auto vertex = imprint.insert(p);
  ASSERT_TRUE(vertex.has_value());
  EXPECT_EQ(imprint.points()[*vertex], p);
  // A vertex of the mesh takes the place of a point next to it, once.
  const Vector3d near = mesh.points[50] * (1 + 1e-4);
  EXPECT_EQ(imprint.insert(near), 50);
  EXPECT_EQ(imprint.points()[50], near);
}

TEST(Imprint, PathsDoNotCross) {
  const HalfEdgeMesh mesh = ball();
  Imprint imprint(mesh, kSnap);
  const auto west = imprint.insert(onCircle(-0.3, 0)), east = imprint.insert(onCircle(0.3, 0));
  const auto north = imprint.insert(onCircle(0, 3)), south = imprint.insert(onCircle(0.01, -3));
  ASSERT_FALSE(imprint.connect(*west, *east, 1).empty());
  const auto second = imprint.connect(*north, *south, 2);
  // There is a long way around, but no direct one.
  if (second.empty()) {
    EXPECT_EQ(imprint.stoppedBy(), 1);
    return;
  }
  for (std::size_t i = 0; i + 1 < second.size(); ++i)
    EXPECT_EQ(imprint.ownerOf(second[i], second[i + 1]), 2);
}

TEST(FlipNeedles, ReplacesATriangleOnALine) {
  // A triangle of a box, divided at a point next to the middle of one of its edges.
  TriMesh mesh = test::makeBox({0, 0, 0}, {4, 4, 4});
  RunContext run;
  HalfEdgeMesh edges = buildHalfEdges(mesh, run);
  Imprint imprint(edges, 0);
  const auto& [a, b, c] = edges.triangles[0];
  const Vector3d middle = (edges.points[a] + edges.points[b]) / 2;
  const Vector3d third = edges.points[c];
  const auto vertex = imprint.insert(middle + 0.3 * (third - middle));
  ASSERT_TRUE(vertex.has_value());
  imprint.move(*vertex, middle + 1e-9 * (third - middle));
  HalfEdgeMesh cut = buildHalfEdges({imprint.points(), imprint.triangles()}, run);
  const auto lowest = [](const HalfEdgeMesh& of) {
    double low = HUGE_VAL;
    for (std::size_t t = 0; t < of.triangles.size(); ++t)
      low = std::min(low, heightOf(of, static_cast<std::int32_t>(t)));
    return low;
  };
  ASSERT_LT(lowest(cut), 1e-6);
  HalfEdgeMesh kept = cut;
  flipNeedles(kept, 0.01, [](std::int32_t) { return false; });
  EXPECT_LT(lowest(kept), 1e-6);
  flipNeedles(cut, 0.01, [](std::int32_t) { return true; });
  EXPECT_GT(lowest(cut), 0.5);
  EXPECT_NEAR(buildHalfEdges({cut.points, cut.triangles}, run).volume, 64, 1e-6);
}

}  // namespace
}  // namespace swept::step
