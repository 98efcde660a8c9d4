// Meshes in single precision: rounding does not change how their triangles are joined.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "io/single_precision.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/shapes.h"
#include "support/temporary_folder.h"
#include "swept/compute.h"
#include "swept/io.h"

namespace swept::test {
namespace {

TriMesh moved(TriMesh mesh, const Eigen::Vector3d& by) {
  for (Eigen::Vector3d& vertex : mesh.vertices) vertex += by;
  return mesh;
}

TEST(SinglePrecision, EveryCoordinateIsTheNearestWhereNothingIsInTheWay) {
  const TriMesh ball = makeBall({100, 0.1, -1e-3}, 5, 4);
  const TriMesh single = inSinglePrecision(ball);
  EXPECT_EQ(single.triangles, ball.triangles);
  for (std::size_t v = 0; v < ball.vertices.size(); ++v) {
    EXPECT_EQ(single.vertices[v], ball.vertices[v].cast<float>().cast<double>());
  }
}

/// At 10 m, neighbouring numbers are a micrometre apart, and the ball's edges are about as long.
TEST(SinglePrecision, VerticesStayApartAndTrianglesKeepTheirAreas) {
  const TriMesh ball = moved(makeBall({0, 0, 0}, 0.03, 5), {10000, 7000, -9000});
  RunContext run;
  TriMesh nearest = ball;
  for (Eigen::Vector3d& vertex : nearest.vertices) {
    vertex = vertex.cast<float>().cast<double>();
  }
  EXPECT_GT(checkMesh(nearest, run).degenerateTriangles, 0) << "nothing was in the way";
  const TriMesh single = inSinglePrecision(ball);
  EXPECT_EQ(checkMesh(single, run).degenerateTriangles, 0);
  for (std::size_t v = 0; v < ball.vertices.size(); ++v) {
    EXPECT_EQ(single.vertices[v], single.vertices[v].cast<float>().cast<double>());
    EXPECT_LT((single.vertices[v] - ball.vertices[v]).norm(), 3 * std::sqrt(3) * 0x1p-10);
  }
  const TemporaryFolder folder;
  writeMesh(ball, folder.file("ball.stl"));
  const TriMesh read = readMesh(folder.file("ball.stl"));
  EXPECT_EQ(read.vertices.size(), ball.vertices.size()) << "none was joined";
  const MeshCheck check = checkMesh(read, run);
  EXPECT_TRUE(check.closed);
  EXPECT_TRUE(check.manifold);
  EXPECT_EQ(check.degenerateTriangles, 0);
}

TEST(SinglePrecision, VerticesAtOnePlaceStayTogether) {
  TriMesh soup = moved(makeBall({0, 0, 0}, 0.03, 5), {10000, 7000, -9000});
  append(soup, TriMesh(soup));
  const TriMesh single = inSinglePrecision(soup);
  const std::size_t half = soup.vertices.size() / 2;
  for (std::size_t v = 0; v < half; ++v) {
    EXPECT_EQ(single.vertices[v], single.vertices[half + v]);
  }
}

}  // namespace
}  // namespace swept::test
