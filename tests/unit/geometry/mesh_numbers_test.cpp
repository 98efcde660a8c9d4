// Counts of faults in a mesh: faults are planted at known places; the first ones are named and
// all are counted.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/mesh_numbers.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/shapes.h"

namespace swept::test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(MeshNumbers, GoodOnes) {
  const TriMesh ball = makeBall({1, 2, -30}, 4, 6);
  EXPECT_FALSE(findBadIndex(ball).has_value());
  EXPECT_FALSE(findBadIndex(TriMesh{}).has_value());
  const Coordinates found = measureCoordinates(ball);
  EXPECT_EQ(found.nonFinite, 0);
  EXPECT_TRUE(found.firstNonFinite.empty());
  std::int64_t farthest = 0;
  for (std::size_t v = 0; v < ball.vertices.size(); ++v) {
    if (ball.vertices[v].cwiseAbs().maxCoeff() == found.largest) {
      farthest = static_cast<std::int64_t>(v);
      break;
    }
  }
  EXPECT_EQ(found.farthest, farthest);
  for (const auto& v : ball.vertices) EXPECT_LE(v.cwiseAbs().maxCoeff(), found.largest);
  EXPECT_EQ(measureCoordinates(TriMesh{}).farthest, -1);
}

TEST(MeshNumbers, FirstBadIndexWhereverItStands) {
  const TriMesh ball = makeBall({0, 0, 0}, 1, 6);
  const auto count = static_cast<std::int32_t>(ball.vertices.size());
  for (const std::size_t t : {std::size_t{0}, std::size_t{16384}, ball.triangles.size() - 1}) {
    for (const std::int32_t value : {-1, count, std::numeric_limits<std::int32_t>::max()}) {
      for (std::size_t k = 0; k < 3; ++k) {
        TriMesh mesh = ball;
        mesh.triangles[t][k] = value;
        mesh.triangles.back()[2] = -7;  // a later bad index, which is not named
        const auto bad = findBadIndex(mesh);
        ASSERT_TRUE(bad.has_value());
        EXPECT_EQ(bad->triangle, static_cast<std::int64_t>(t));
        const bool last = t + 1 == ball.triangles.size() && k == 2;
        EXPECT_EQ(bad->vertex, last ? -7 : value);
      }
    }
  }
}

TEST(MeshNumbers, NonFiniteOnesAreCountedAndTheFirstListed) {
  TriMesh mesh = makeBall({0, 0, 0}, 1, 6);
  std::vector<std::int64_t> planted;
  for (std::size_t v = 5; v < mesh.vertices.size(); v += 3001) {
    mesh.vertices[v][v % 3] = v % 2 == 0 ? kNan : -std::numeric_limits<double>::infinity();
    planted.push_back(static_cast<std::int64_t>(v));
  }
  mesh.vertices[7] = {0, -1e9, 2};
  mesh.vertices[9] = {1e9, 0, 2};
  const Coordinates found = measureCoordinates(mesh);
  ASSERT_GT(planted.size(), 8U);
  EXPECT_EQ(found.nonFinite, std::ssize(planted));
  planted.resize(8);
  EXPECT_EQ(found.firstNonFinite, planted);
  EXPECT_EQ(found.largest, 1e9);
  EXPECT_EQ(found.farthest, 7);
}

}  // namespace
}  // namespace swept::test
