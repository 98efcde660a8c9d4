// Curves in which carriers intersect, and edges cut in two.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/carrier/section.h"

#include <gtest/gtest.h>

#include <cmath>

#include "solid/model/gaps.h"
#include "solid/model/split_edges.h"

namespace swept::step {
namespace {

using Eigen::Vector3d;

Carrier plane(const Vector3d& normal, const Vector3d& point) {
  Carrier carrier;
  carrier.kind = CarrierKind::Plane;
  carrier.axis = normal.normalized();
  carrier.point = point;
  return carrier;
}

Carrier cylinder(const Vector3d& axis, const Vector3d& point, double radius) {
  Carrier carrier;
  carrier.kind = CarrierKind::Cylinder;
  carrier.axis = axis.normalized();
  carrier.point = point;
  carrier.radius = radius;
  return carrier;
}

// Tests the curve at many more points than were tested when it was made.
void expectOnBoth(const Curve& curve, const Carrier& a, const Carrier& b) {
  for (int i = 0; i <= 5000; ++i) {
    const Vector3d p = curve.at(curve.last * i / 5000);
    ASSERT_LE(std::abs(a.distance(p)), 1e-7);
    ASSERT_LE(std::abs(b.distance(p)), 1e-7);
  }
}

TEST(SectionCurve, EllipseOfAPlaneAndACylinder) {
  const Carrier tube = cylinder({0, 0, 1}, {0, 0, 0}, 5), cut = plane({1, 0, 2}, {0, 0, 3});
  const auto at = [](double angle) {
    const double x = 5 * std::cos(angle);
    return Vector3d(x, 5 * std::sin(angle), 3 - x / 2);
  };
  const auto arc = sectionCurve({at(0.2), at(1.1)}, false, tube, cut, 2);
  ASSERT_TRUE(arc);
  EXPECT_EQ(arc->kind, CurveKind::Spline);
  expectOnBoth(*arc, tube, cut);
  EXPECT_LT((arc->at(0) - at(0.2)).norm(), 1e-12);
  EXPECT_LT((arc->at(arc->last) - at(1.1)).norm(), 1e-12);
}

TEST(SectionCurve, CircleAndLineAreThemselves) {
  const Carrier tube = cylinder({0, 0, 1}, {0, 0, 0}, 5);
  const Carrier across = plane({0, 0, 1}, {0, 0, 2}), along = plane({1, 0, 0}, {3, 0, 0});
  std::vector<Vector3d> ring;
  for (int i = 0; i <= 24; ++i)
    ring.emplace_back(5 * std::cos(M_PI * i / 12), 5 * std::sin(M_PI * i / 12), 2);
  const auto circle = sectionCurve(ring, true, tube, across, 1);
  ASSERT_TRUE(circle);
  EXPECT_EQ(circle->kind, CurveKind::Circle);
  EXPECT_NEAR(circle->radius, 5, 1e-9);
  const auto line = sectionCurve({{3, 4, 0}, {3, 4, 9}}, false, tube, along, 1);
  ASSERT_TRUE(line);
  EXPECT_EQ(line->kind, CurveKind::Line);
}

TEST(SectionCurve, TwoCylinders) {
  const Carrier one = cylinder({0, 0, 1}, {0, 0, 0}, 5), two = cylinder({1, 0, 0}, {0, 1, 0}, 3);
  const auto at = [](double y) {
    return Vector3d(std::sqrt(25 - y * y), y, std::sqrt(9 - (y - 1) * (y - 1)));
  };
  const auto curve = sectionCurve({at(-1), at(0), at(1), at(2)}, false, one, two, 2);
  ASSERT_TRUE(curve);
  expectOnBoth(*curve, one, two);
}

TEST(SectionCurve, APlaneCutsAnExtrusionInItsProfile) {
  std::vector<Profile::Node> nodes;
  for (int i = 0; i <= 8; ++i) {  // a parabola, parametrised by x
    const double x = i - 4;
    nodes.push_back({{x, x * x / 8}, {1, x / 4}, x});
  }
  // A jump in the curvature, as fitted profiles have them.
  nodes[5].slope.y() += 0.05;
  Carrier pushed;
  pushed.kind = CarrierKind::Extrusion;
  pushed.axis = Vector3d(0.1, 0.2, 1).normalized();
  pushed.xdir = pushed.axis.unitOrthogonal();
  pushed.profile = std::make_shared<const Profile>(nodes, false, 1);
  const Carrier cut = plane({0.3, 0, 1}, {0, 0, 4});
  const auto on = [&](double t) {
    const Eigen::Vector2d q = pushed.profile->at(t);
    const Vector3d p = q.x() * pushed.xdir + q.y() * pushed.axis.cross(pushed.xdir);
    return Vector3d(p - cut.distance(p) / cut.axis.dot(pushed.axis) * pushed.axis);
  };
  for (const auto& [from, to] : {std::pair(-2.5, 3.2), std::pair(3.2, -2.5)}) {
    const auto curve = sectionCurve({on(from), on(to)}, false, pushed, cut, 9);
    ASSERT_TRUE(curve);
    expectOnBoth(*curve, pushed, cut);
    EXPECT_LT((curve->at(0) - on(from)).norm(), 1e-9);
  }
}

TEST(SectionCurve, NothingWhereCarriersTouchOrTheCurveStrays) {
  const Carrier tube = cylinder({0, 0, 1}, {0, 0, 0}, 5);
  const Carrier leaning = cylinder({0, 0.004, 1}, {-1, 0, 0}, 6);
  EXPECT_FALSE(sectionCurve({{5, 0, 0}, {5, 0, 9}}, false, tube, leaning, 1));
  // The chord is 4 mm off the arc.
  EXPECT_FALSE(
      sectionCurve({{3, 4, 0}, {3, -4, 0}}, false, tube, plane({0, 0, 1}, {0, 0, 0}), 0.5));
}

TEST(CutEdges, PartsAreTheWhole) {
  const Carrier tube = cylinder({0, 0, 1}, {0, 0, 0}, 5), cut = plane({1, 0, 2}, {0, 0, 3});
  const Vector3d a(5, 0, 0.5), b(0, 5, 3);
  Curve circle;
  circle.kind = CurveKind::Circle;
  circle.radius = 5;
  circle.last = 2;
  const Curve spline = *sectionCurve({a, b}, false, tube, cut, 3);
  ASSERT_EQ(spline.kind, CurveKind::Spline);
  for (const Curve& whole : {lineThrough(a, b), circle, spline}) {
    for (const double part : {0.37, 0.5}) {  // 0.5: a knot of the spline
      Model model;
      model.vertices = {{whole.at(0), 0}, {whole.at(whole.last), 0}};
      model.edges = {{0, 1, whole, 0.25}};
      model.faces.resize(2);
      model.faces[0].loops = {{{0, true}}};
      model.faces[1].loops = {{{0, false}}};
      splitEdges({{0, part * whole.last}}, model);
      ASSERT_EQ(model.edges.size(), 2);
      ASSERT_EQ(model.vertices.size(), 3);
      EXPECT_EQ(model.edges[0].end, 2);
      EXPECT_EQ(model.edges[1].start, 2);
      EXPECT_EQ(model.edges[1].end, 1);
      EXPECT_EQ(model.edges[1].tolerance, 0.25);
      for (int i = 0; i <= 100; ++i) {
        const double t = whole.last * i / 100, border = part * whole.last;
        const Curve& low = model.edges[0].curve;
        const Curve& high = model.edges[1].curve;
        const Vector3d p = t <= border ? low.at(low.last * t / border)
                                       : high.at(high.last * (t - border) / (whole.last - border));
        EXPECT_LT((p - whole.at(t)).norm(), 1e-9);
      }
      // Each loop contains both parts of the edge, in its own direction.
      EXPECT_EQ(model.faces[0].loops[0][0].edge, 0);
      EXPECT_EQ(model.faces[0].loops[0][1].edge, 1);
      EXPECT_EQ(model.faces[1].loops[0][0].edge, 1);
      EXPECT_EQ(model.faces[1].loops[0][1].edge, 0);
      EXPECT_FALSE(model.faces[1].loops[0][1].forward);
    }
  }
}

TEST(LooseFaces, AnEdgeBesideAFacetLiesOnTheFace) {
  Model model;
  model.vertices = {{{5, 0, 0}, 0}, {{3, 4, 0}, 0}};
  model.edges = {{0, 1, lineThrough({5, 0, 0}, {3, 4, 0}), 0.5}};
  model.faces.resize(2);
  model.faces[0] = {cylinder({0, 0, 1}, {0, 0, 0}, 5), {{{0, true}}}, 0, 0};
  model.faces[1] = {plane({0, 0, 1}, {0, 0, 0}), {{{0, false}}}, 0, 1};
  model.faces[1].surface.kind = CarrierKind::Facet;
  EXPECT_EQ(findLooseFaces(model, 1, 1.0), std::vector<std::int32_t>{0});
  // Between two recognised faces a gap is allowed up to the tolerance.
  model.faces[1].surface.kind = CarrierKind::Plane;
  EXPECT_TRUE(findLooseFaces(model, 2, 1.0).empty());
  EXPECT_EQ(findLooseFaces(model, 2, 0.1), std::vector<std::int32_t>{0});
  model.edges[0].curve = *sectionCurve({{5, 0, 0}, {3, 4, 0}}, false, model.faces[0].surface,
                                       model.faces[1].surface, 1);
  EXPECT_TRUE(findLooseFaces(model, 1, 1.0).empty());
}

}  // namespace
}  // namespace swept::step
