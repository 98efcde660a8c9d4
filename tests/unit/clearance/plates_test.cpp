// Flat cylinders around groups of triangles: they contain their triangles, and their distances
// are lower bounds.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "clearance/plates.h"

#include <gtest/gtest.h>

#include "clearance/part.h"
#include "support/random_numbers.h"
#include "support/sampled.h"
#include "support/shapes.h"

namespace swept::clearance {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using namespace swept::test;

/// Returns a mesh with groups of triangles that are curved, slanted or without area, in both
/// orientations.
TriMesh mixture() {
  TriMesh mesh = makeTorus(10, 3, 30, 16);
  append(mesh, makeBox({6, 6, -20}, {7, 7, 20}));
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3)
    std::swap(mesh.triangles[i][0], mesh.triangles[i][1]);
  const auto first = static_cast<std::int32_t>(mesh.vertices.size());
  for (int k = 0; k < 9; ++k) mesh.vertices.push_back(Vector3d(30 + k, 0, 0));
  mesh.triangles.push_back({first, first + 1, first + 8});  // a needle
  for (int k = 0; k < 8; ++k) mesh.triangles.push_back({first + k, first + k, first + k});
  return mesh;
}

std::vector<Vector3d> cornersOf(const Part& part, BoxTree::Node node) {
  std::uint32_t width = 1;
  for (std::int32_t level = 0; level < node.level; ++level) width *= BoxTree::kWidth;
  const auto end = std::min<std::uint32_t>((node.index + 1) * width, part.tree().count(0));
  std::vector<Vector3d> corners;
  for (std::uint32_t place = node.index * width; place < end; ++place)
    for (const Vector3d& x : part.corners(place)) corners.push_back(x);
  return corners;
}

bool holds(const Plate& plate, const std::vector<Vector3d>& corners) {
  constexpr double kRounding = 1e-12;
  return std::all_of(corners.begin(), corners.end(), [&](const Vector3d& x) {
    const Vector3d off = x - plate.centre;
    const double along = plate.axis.dot(off);
    return std::abs(along) <= plate.half + kRounding &&
           (off - along * plate.axis).norm() <= plate.radius + kRounding;
  });
}

std::vector<BoxTree::Node> nodesWithPlates(const Part& part) {
  std::vector<BoxTree::Node> nodes;
  for (std::int32_t level = 0; level <= part.tree().root().level; ++level)
    for (std::uint32_t i = 0; i < part.tree().count(level); ++i)
      if (part.plate({level, i}) != nullptr) nodes.push_back({level, i});
  return nodes;
}

TEST(Plates, HoldEveryCornerAndNoMoreThanNeeded) {
  const Part part(mixture(), "the mixture");
  const auto nodes = nodesWithPlates(part);
  EXPECT_GT(nodes.size(), part.tree().count(1));
  EXPECT_EQ(part.plate({0, 0}), nullptr);
  for (const BoxTree::Node node : nodes) {
    const Plate& plate = *part.plate(node);
    const auto corners = cornersOf(part, node);
    EXPECT_NEAR(plate.axis.norm(), 1, 1e-12);
    EXPECT_TRUE(holds(plate, corners));
    Plate less = plate;
    less.radius *= 0.99;
    EXPECT_TRUE(plate.radius == 0 || !holds(less, corners));
    less = plate;
    less.half *= 0.99;
    EXPECT_TRUE(plate.half < 1e-9 || !holds(less, corners));
  }
}

TEST(Plates, AreFlatOnAFineBall) {
  const Part part(makeBall(Vector3d::Zero(), 10, 5), "a ball");
  for (std::uint32_t i = 0; i < part.tree().count(1); ++i) {
    const Plate& plate = *part.plate({1, i});
    EXPECT_LT(plate.half, 0.1 * plate.radius);
  }
}

TEST(PlateGap, NoTwoCornersAreNearerAlongItsDirection) {
  Random random(5);
  const Part a(mixture(), "a");
  const Part b(makeBall({0, 0, 0}, 12, 3), "b");
  const auto nodesA = nodesWithPlates(a), nodesB = nodesWithPlates(b);
  const auto any = [&](const auto& nodes) {
    return nodes[static_cast<std::size_t>(random.number(0, 0.999) * double(nodes.size()))];
  };
  int apart = 0;
  for (int k = 0; k < sampled(20000, 2000); ++k) {
    const Eigen::Isometry3d place = placement(random.point(1) + Vector3d(0, 0, 1e-3),
                                              random.number(-180, 180), random.point(9));
    const Matrix3d R = place.linear();
    const Vector3d t = place.translation();
    const BoxTree::Node i = any(nodesA), j = any(nodesB);
    PlateGap gap(R, t);
    const double found = gap.between(*a.plate(i), *b.plate(j));
    const Vector3d n = gap.direction();
    double farthest = -1e300, nearest = 1e300;
    for (const Vector3d& x : cornersOf(a, i)) farthest = std::max(farthest, n.dot(R * x + t));
    for (const Vector3d& x : cornersOf(b, j)) nearest = std::min(nearest, n.dot(x));
    EXPECT_NEAR(n.norm(), 1, 1e-12);
    EXPECT_LE(found, nearest - farthest + 1e-9);
    apart += found > 0;
  }
  EXPECT_GT(apart, sampled(20000, 2000) / 4);
}

}  // namespace
}  // namespace swept::clearance
