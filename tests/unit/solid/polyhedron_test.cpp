// What the solids of turning bodies begin with: zeros of functions of time, and the parts of a
// polyhedron.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/polyhedron.h"

#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <algorithm>
#include <cmath>

#include "solid/assemble/zeros.h"

namespace swept::step {
namespace {

TopoDS_Shape notchedBox() {
  return BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(12, 9, 5).Shape(),
                         BRepPrimAPI_MakeBox(gp_Pnt(4, 3, -1), gp_Pnt(20, 20, 9)).Shape())
      .Shape();
}

TEST(Polyhedron, KnowsItsNormalsAndItsConcaveEdge) {
  const Polyhedron body(notchedBox());
  EXPECT_EQ(body.faces.size(), 8u);
  ASSERT_EQ(body.edges.size(), 18u);
  for (const BodyFace& face : body.faces) {
    const BodyEdge& edge = body.edges[face.edges.front()];
    EXPECT_NEAR(edge.along.dot(face.normal), 0, 1e-12);
  }
  for (const BodyEdge& edge : body.edges) {
    const Eigen::Vector3d middle = edge.at(edge.length / 2);
    const bool isNotch = (middle - Eigen::Vector3d(4, 3, 2.5)).norm() < 1e-9;
    EXPECT_EQ(body.isConvex(edge), !isNotch) << middle.transpose();
    for (const int f : edge.faces) EXPECT_GE(f, 0);
  }
  const auto isOutward = [&](const Eigen::Vector3d& normal, const Eigen::Vector3d& p) {
    return std::any_of(body.faces.begin(), body.faces.end(), [&](const BodyFace& face) {
      return (face.normal - normal).norm() < 1e-12 &&
             std::abs(normal.dot(body.edges[face.edges.front()].start - p)) < 1e-12;
    });
  };
  EXPECT_TRUE(isOutward({-1, 0, 0}, {0, 0, 0}));
  EXPECT_TRUE(isOutward({1, 0, 0}, {12, 0, 0}));
  EXPECT_TRUE(isOutward({1, 0, 0}, {4, 5, 0}));
  EXPECT_FALSE(isOutward({-1, 0, 0}, {12, 0, 0}));
}

TEST(Polyhedron, HasNoCurvedFace) {
  EXPECT_TRUE(isPolyhedron(notchedBox()));
  EXPECT_FALSE(isPolyhedron(BRepPrimAPI_MakeCylinder(2, 5).Shape()));
}

TEST(Zeros, AreFoundInOrder) {
  const std::vector<double> zeros = zerosOf([](double t) { return std::cos(10 * t); }, {0, 1});
  ASSERT_EQ(zeros.size(), 3u);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(zeros[i], (0.5 + i) * M_PI / 10, 1e-12);
  EXPECT_TRUE(zerosOf([](double t) { return 1 + t; }, {0, 1}).empty());
}

TEST(Zeros, BoundTheTimesWithinARange) {
  const std::vector<Range> within =
      timesWithin([](double t) { return (t - 0.5) * (t - 0.5); }, 0.01, 0.04, {0, 1});
  ASSERT_EQ(within.size(), 2u);
  EXPECT_NEAR(within[0].from, 0.3, 1e-12);
  EXPECT_NEAR(within[0].to, 0.4, 1e-12);
  EXPECT_NEAR(within[1].from, 0.6, 1e-12);
  EXPECT_NEAR(within[1].to, 0.7, 1e-12);
}

}  // namespace
}  // namespace swept::step
