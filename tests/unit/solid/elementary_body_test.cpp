// What the solids of turning bodies begin with: zeros of functions, and the parts of a body with
// planes and cylinders.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/elementary_body.h"

#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <algorithm>
#include <cmath>

#include "motion/step_path.h"
#include "solid/assemble/body_motion.h"
#include "solid/assemble/zero_curves.h"

namespace swept::step {
namespace {

TopoDS_Shape notchedBox() {
  return BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(12, 9, 5).Shape(),
                         BRepPrimAPI_MakeBox(gp_Pnt(4, 3, -1), gp_Pnt(20, 20, 9)).Shape())
      .Shape();
}

TEST(ElementaryBody, KnowsItsNormalsAndItsConcaveEdge) {
  const ElementaryBody body(notchedBox());
  EXPECT_EQ(body.faces.size(), 8u);
  ASSERT_EQ(body.edges.size(), 18u);
  for (const BodyFace& face : body.faces) {
    const BodyEdge& edge = body.edges[face.edges.front()];
    EXPECT_NEAR(edge.tangent(0).dot(body.surfaces[face.surface].axis), 0, 1e-12);
  }
  for (const BodyEdge& edge : body.edges) {
    const Eigen::Vector3d middle = edge.at(edge.range.at(0.5));
    const bool isNotch = (middle - Eigen::Vector3d(4, 3, 2.5)).norm() < 1e-9;
    EXPECT_NEAR(body.convexity(edge), isNotch ? -1 : 1, 1e-12) << middle.transpose();
    for (const int f : edge.faces) EXPECT_GE(f, 0);
  }
  const auto isOutward = [&](const Eigen::Vector3d& normal, const Eigen::Vector3d& p) {
    return std::any_of(body.faces.begin(), body.faces.end(), [&](const BodyFace& face) {
      const BodyEdge& edge = body.edges[face.edges.front()];
      return (body.surfaces[face.surface].normalAt(p) - normal).norm() < 1e-12 &&
             std::abs(normal.dot(edge.at(edge.range.from) - p)) < 1e-12;
    });
  };
  EXPECT_TRUE(isOutward({-1, 0, 0}, {0, 0, 0}));
  EXPECT_TRUE(isOutward({1, 0, 0}, {12, 0, 0}));
  EXPECT_TRUE(isOutward({1, 0, 0}, {4, 5, 0}));
  EXPECT_FALSE(isOutward({-1, 0, 0}, {12, 0, 0}));
}

TEST(ElementaryBody, CutsClosedFacesAndKnowsTheirSurface) {
  EXPECT_TRUE(isElementary(notchedBox()));
  EXPECT_FALSE(isElementary(BRepPrimAPI_MakeCone(2, 1, 5).Shape()));
  const ElementaryBody body(BRepPrimAPI_MakeCylinder(2, 5).Shape());
  EXPECT_EQ(body.faces.size(), 4u);
  EXPECT_EQ(body.surfaces.size(), 3u);
  ASSERT_EQ(body.edges.size(), 6u);
  const auto lines = std::count_if(body.edges.begin(), body.edges.end(), [&](const BodyEdge& edge) {
    return std::abs(body.convexity(edge)) < 1e-12 && edge.scale == 1;
  });
  const auto arcs = std::count_if(body.edges.begin(), body.edges.end(), [&](const BodyEdge& edge) {
    return std::abs(body.convexity(edge) - 1) < 1e-12 && std::abs(edge.scale - 2) < 1e-12;
  });
  EXPECT_EQ(lines, 2);
  EXPECT_EQ(arcs, 4);
  for (const BodySurface& surface : body.surfaces) {
    const Eigen::Vector3d p(2, 0, 1), away = surface.normalAt(p);
    const double up = surface.origin.z() > 1 ? 1 : -1;
    const Eigen::Vector3d expected =
        surface.isPlane() ? Eigen::Vector3d(0, 0, up) : p.cwiseProduct(Eigen::Vector3d(0.5, 0, 0));
    EXPECT_NEAR((away - expected).norm(), 0, 1e-12);
  }
}

TEST(ElementaryBody, KnowsTheCornersOfItsFaces) {
  const ElementaryBody body(notchedBox());
  int corners = 0, others = 0;
  for (std::size_t f = 0; f < body.faces.size(); ++f) {
    for (int v = 0; v < body.vertices.Extent(); ++v) {
      const bool isAtFace =
          std::any_of(body.faces[f].edges.begin(), body.faces[f].edges.end(),
                      [&](int e) { return body.edges[e].from == v || body.edges[e].to == v; });
      if (!isAtFace) continue;
      ++(body.isCorner(v, static_cast<int>(f)) ? corners : others);
    }
  }
  EXPECT_EQ(corners, 6 * 4 + 2 * 5);
  EXPECT_EQ(others, 2) << "the notch, in the top and the bottom";
}

Pose poseAt(const Eigen::Vector3d& place, double angle, const Eigen::Vector3d& axis) {
  Pose pose;
  pose.translation = place;
  pose.rotation = Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis));
  return pose;
}

TEST(BodyMotion, KnowsWhatSlidesAndWhatTurnsInAPlane) {
  const ElementaryBody body(notchedBox());
  const StepPath path(poseAt({0, 0, 0}, 0, Eigen::Vector3d::UnitZ()),
                      poseAt({20, 5, 0}, 0.3, Eigen::Vector3d::UnitZ()), Interpolation::Linear);
  const BodyMotion motion(body, path);
  for (std::size_t f = 0; f < body.faces.size(); ++f) {
    const bool isFlat = std::abs(body.surfaceOf(static_cast<int>(f)).axis.z()) > 0.5;
    EXPECT_EQ(motion.slides(static_cast<int>(f)), isFlat);
  }
  for (const BodyEdge& edge : body.edges) {
    const bool isFlat = std::abs(edge.tangent(edge.range.from).z()) < 0.5;
    EXPECT_EQ(motion.slidesAt(edge), isFlat);
    ASSERT_EQ(motion.planeOf(edge).has_value(), isFlat);
    if (!isFlat) continue;
    EXPECT_NEAR(std::abs(motion.planeOf(edge)->z()), 1, 1e-12);
  }
  const StepPath line(poseAt({0, 0, 0}, 0, Eigen::Vector3d::UnitZ()),
                      poseAt({20, 5, 3}, 0, Eigen::Vector3d::UnitZ()), Interpolation::Linear);
  const BodyMotion straight(body, line);
  EXPECT_FALSE(straight.doesTurn());
  for (std::size_t f = 0; f < body.faces.size(); ++f)
    EXPECT_FALSE(straight.slides(static_cast<int>(f)));
}

// The ends of the arcs at the seams of a cylinder touch the envelope all the time.
TEST(BodyMotion, FindsContactAtTheEndsOfEdges) {
  const ElementaryBody body(BRepPrimAPI_MakeCylinder(2, 5).Shape());
  const StepPath path(poseAt({0, 0, 0}, 0, Eigen::Vector3d::UnitZ()),
                      poseAt({0, 20, 0}, 0, Eigen::Vector3d::UnitZ()), Interpolation::Linear);
  const BodyMotion motion(body, path);
  int found = 0;
  for (const BodyEdge& edge : body.edges) {
    for (const int f : edge.faces) {
      if (body.surfaceOf(f).isPlane()) continue;
      for (const ZeroArc& arc : motion.contactsOf(edge, f, {0, 1})) {
        const Eigen::Vector2d on = arc.at(arc.range().at(0.5));
        EXPECT_NEAR(std::abs(edge.at(on.x()).x()), 2, 1e-9);
        EXPECT_NEAR(arc.range().length(), 20, 1e-9);
        ++found;
      }
    }
  }
  EXPECT_EQ(found, 8) << "two at each of four arcs, none at the seams";
}

TEST(Zeros, AreFoundInOrder) {
  const std::vector<double> zeros = zerosOf([](double t) { return std::cos(10 * t); }, {0, 1});
  ASSERT_EQ(zeros.size(), 3u);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(zeros[i], (0.5 + i) * M_PI / 10, 1e-12);
  EXPECT_TRUE(zerosOf([](double t) { return 1 + t; }, {0, 1}).empty());
}

TEST(Zeros, AreCurvesInTheParameters) {
  // A circle, a line that crosses the rectangle, and a saddle.
  const Range x{-2, 2}, y{-1, 3};
  const auto length = [&](const OfTwo& f) {
    double sum = 0;
    for (const ZeroArc& arc : zeroArcs(f, x, y, {1, 1})) {
      const Range range = arc.range();
      constexpr int kPieces = 1000;
      for (int i = 0; i < kPieces; ++i) {
        const Eigen::Vector2d p = arc.at(range.at(i / double(kPieces)));
        EXPECT_NEAR(f(p), 0, 1e-12);
        sum += (arc.at(range.at((i + 1) / double(kPieces))) - p).norm();
      }
    }
    return sum;
  };
  EXPECT_NEAR(length([](const Eigen::Vector2d& p) { return p.squaredNorm() - 0.49; }),
              2 * M_PI * 0.7, 1e-4);
  EXPECT_NEAR(length([](const Eigen::Vector2d& p) { return p.x() - p.y() / 2; }), 2 * std::sqrt(5),
              1e-9);
  EXPECT_NEAR(length([](const Eigen::Vector2d& p) { return p.x() * (p.y() - 1.01) - 1e-4; }), 8,
              0.1);
  EXPECT_EQ(length([](const Eigen::Vector2d& p) { return p.x() + 5; }), 0);
}

}  // namespace
}  // namespace swept::step
