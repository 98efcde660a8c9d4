// Surfaces that curves of a moving body sweep, compared with formulas and with the motion
// itself.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include "solid/sweep/borders.h"
#include "solid/sweep/motions.h"
#include "solid/sweep/swept_surface.h"

namespace swept::step {
namespace {

// Tests that every point that the curve passes lies on the carrier, and that the normal there is
// orthogonal to the surface. Independent of how the surface was made.
void expectSweptBy(const SweptSurface& swept, const Curve& curve, Range along,
                   const TestMotion& motion, double bound = kOnCarrier) {
  ASSERT_TRUE(swept.carrier) << degeneracyText(swept.why);
  for (int i = 0; i <= 37; ++i) {
    for (int j = 0; j <= 41; ++j) {
      const double u = along.at(i / 37.0), s = j / 41.0, h = 1e-4;
      const Vector3d p = motion.at(curve.at(u), s);
      ASSERT_LE(std::abs(swept.carrier->distance(p)), bound) << u << " " << s;
      const Vector3d alongU = motion.at(curve.at(u + h), s) - motion.at(curve.at(u - h), s);
      const Vector3d n = swept.carrier->normal(p);
      // A surface that is off by the bound is inclined by about as much per mm.
      ASSERT_NEAR(n.dot(alongU.normalized()), 0, 1e-5 + bound);
      ASSERT_NEAR(n.dot(motion.velocity(curve.at(u), s).normalized()), 0, 1e-5 + bound);
    }
  }
}

TEST(SweptCurve, ALineTurnedAboutAnAxis) {
  const TestMotion turn = screwMotion({1, 2, 3}, {0, 0, 1}, 1.2, 0);
  const auto swept = [&](const Vector3d& a, const Vector3d& b, double bound = kOnCarrier) {
    const Curve line = lineThrough(a, b);
    const auto made = sweptBy(line, {0, line.last}, turn.path(), kWhole, bound);
    expectSweptBy(made, line, {0, line.last}, turn, 2 * bound);
    return made.carrier.value_or(Carrier{});
  };
  const Carrier parallel = swept({11, 2, 0}, {11, 2, 20});
  EXPECT_EQ(parallel.kind, CarrierKind::Cylinder);
  EXPECT_NEAR(parallel.radius, 10, 1e-9);
  EXPECT_EQ(swept({5, 2, 7}, {15, 2, 7}).kind, CarrierKind::Plane);
  EXPECT_EQ(swept({5, 4, 7}, {15, -3, 7}).kind, CarrierKind::Plane);
  const Carrier crossing = swept({5, 2, 7}, {15, 2, 17});
  EXPECT_EQ(crossing.kind, CarrierKind::Cone);
  EXPECT_NEAR(std::abs(crossing.halfAngle), M_PI / 4, 1e-9);
  // A skew line gives a hyperboloid of one sheet: x = 1 + 10, y = 2 + h, z = 5 + 2 h.
  // Few cubics are within 1e-4 mm of it, but only a sheet is as near as the kernel's tolerance.
  for (const double bound : {1e-4, kOnCarrier}) {
    const Carrier skew = swept({11, -4, -7}, {11, 10, 21}, bound);
    EXPECT_EQ(skew.kind, bound > kOnCarrier ? CarrierKind::Revolution : CarrierKind::Sheet);
    for (const double z : {-3.0, 0.5, 5.0, 12.0}) {
      const double radius = std::sqrt(100 + std::pow((z - 5) / 2, 2)), angle = 0.7;
      const Vector3d p(1 + radius * std::cos(angle), 2 + radius * std::sin(angle), z);
      EXPECT_NEAR(skew.distance(p), 0, 2 * bound);
    }
  }
}

TEST(SweptCurve, ALineAlongAStraightWay) {
  const TestMotion move = lineMotion({10, 20, 30});
  const Curve line = lineThrough({0, 0, 0}, {5, -7, 2});
  const auto made = sweptBy(line, {0, line.last}, move.path(), kWhole);
  expectSweptBy(made, line, {0, line.last}, move);
  EXPECT_EQ(made.carrier->kind, CarrierKind::Plane);
  const Curve along = lineThrough({0, 0, 0}, {1, 2, 3});
  EXPECT_EQ(sweptBy(along, {0, along.last}, move.path(), kWhole).why, Degeneracy::AlongItself);
  const TestMotion rest = lineMotion({0, 0, 0});
  EXPECT_EQ(sweptBy(line, {0, line.last}, rest.path(), kWhole).why, Degeneracy::AtRest);
}

TEST(SweptCurve, ACircleAlongAStraightWay) {
  const Curve circle = circleCurve({1, 2, 3}, {0, 0, 1}, 5);
  const Range half{0.2, 3.2};
  const TestMotion up = lineMotion({0, 0, 30}), slanted = lineMotion({10, 0, 30}),
                   flat = lineMotion({10, 5, 0});
  const auto pipe = sweptBy(circle, half, up.path(), kWhole);
  expectSweptBy(pipe, circle, half, up);
  EXPECT_EQ(pipe.carrier->kind, CarrierKind::Cylinder);
  const auto oval = sweptBy(circle, half, slanted.path(), kWhole, 1e-4);
  expectSweptBy(oval, circle, half, slanted, 2e-4);
  EXPECT_EQ(oval.carrier->kind, CarrierKind::Extrusion);
  const auto plane = sweptBy(circle, half, flat.path(), kWhole);
  ASSERT_TRUE(plane.carrier);
  EXPECT_EQ(plane.carrier->kind, CarrierKind::Plane);
}

TEST(SweptCurve, ACircleTurnedAboutAnAxis) {
  const TestMotion turn = screwMotion({0, 0, 0}, {0, 0, 1}, 1.5, 0);
  const Range part{0.3, 2.5};
  const auto kindOf = [&](const Curve& circle) {
    const auto made = sweptBy(circle, part, turn.path(), kWhole, 1e-4);
    expectSweptBy(made, circle, part, turn, 2e-4);
    return made.carrier ? made.carrier->kind : CarrierKind::Facet;
  };
  EXPECT_EQ(kindOf(circleCurve({20, 0, 3}, {0, 1, 0}, 5)), CarrierKind::Torus);
  EXPECT_EQ(kindOf(circleCurve({20, 5, 3}, {0, 0, 1}, 5)), CarrierKind::Plane);
  // A circle whose own axis meets the axis of turning lies on a sphere about the point of meeting.
  EXPECT_EQ(kindOf(circleCurve({10, 0, 10}, {1, 0, 1}, 4)), CarrierKind::Sphere);
  EXPECT_EQ(kindOf(circleCurve({20, 0, 3}, {1, 2, 1}, 5)), CarrierKind::Revolution);
  const Curve own = circleCurve({0, 0, 4}, {0, 0, 1}, 5);
  EXPECT_EQ(sweptBy(own, part, turn.path(), kWhole).why, Degeneracy::AlongItself);
}

TEST(SweptCurve, ScrewsKeepCylindersOnly) {
  const TestMotion screw = screwMotion({0, 0, 0}, {0, 0, 1}, 1.5, 12);
  const Curve line = lineThrough({7, 0, 0}, {7, 0, 10});
  const auto pipe = sweptBy(line, {0, 10}, screw.path(), kWhole);
  expectSweptBy(pipe, line, {0, 10}, screw);
  EXPECT_EQ(pipe.carrier->kind, CarrierKind::Cylinder);
  const Curve circle = circleCurve({20, 0, 0}, {0, 1, 0}, 5);
  const Range part{0.3, 2.5};
  const auto worm = sweptBy(circle, part, screw.path(), kWhole);
  expectSweptBy(worm, circle, part, screw);
  EXPECT_EQ(worm.carrier->kind, CarrierKind::Sheet);
  const Curve flat = lineThrough({5, 0, 0}, {15, 0, 0});
  const auto helicoid = sweptBy(flat, {0, 10}, screw.path(), kWhole);
  expectSweptBy(helicoid, flat, {0, 10}, screw);
  EXPECT_EQ(helicoid.carrier->kind, CarrierKind::Sheet);
}

TEST(SweptCurve, AGeneralMotionNeedsFewPoles) {
  for (const double angle : {0.1, 0.7, 1.6}) {
    const TestMotion motion = generalMotion(angle);
    const Curve line = lineThrough({-20, -12, 0}, {20, -12, 5});
    const auto ruled = sweptBy(line, {0, line.last}, motion.path(), kWhole);
    expectSweptBy(ruled, line, {0, line.last}, motion, 2 * kOnCarrier);
    ASSERT_EQ(ruled.carrier->kind, CarrierKind::Sheet);
    EXPECT_LE(ruled.error, kOnCarrier);
    EXPECT_LE(ruled.carrier->sheet->poles().size(), 2U * 18U) << angle;
    const Curve circle = circleCurve({5, 0, 15}, {1, 0.2, 0}, 8);
    const Range part{0.5, 2};
    const auto round = sweptBy(circle, part, motion.path(), kWhole);
    expectSweptBy(round, circle, part, motion, 2 * kOnCarrier);
    ASSERT_EQ(round.carrier->kind, CarrierKind::Sheet);
    EXPECT_LE(round.error, kOnCarrier);
    EXPECT_LE(round.carrier->sheet->poles().size(), 240U) << angle;
  }
}

TEST(SweptCurve, ASplineOfTheBody) {
  const Curve spline = splineAlong(
      {{0, 0, 0}, {10, 3, 1}, {18, 2, 6}},
      {Vector3d(1, 0, 0), Vector3d(1, 0.2, 0.3).normalized(), Vector3d(1, -0.3, 0.8).normalized()});
  const Range along{0, 0.49};  // within one span
  TestMotion motion = generalMotion();
  motion.to.translation = Vector3d(-5, 30, 45);  // moves across the curve
  const auto made = sweptBy(spline, along, motion.path(), kWhole);
  expectSweptBy(made, spline, along, motion, 2 * kOnCarrier);
  EXPECT_EQ(made.carrier->kind, CarrierKind::Sheet);
  // Over its inner knot, where its curvature jumps, the sheet has the knots of the curve.
  const Range whole{0, 0.9};
  const auto all = sweptBy(spline, whole, motion.path(), kWhole);
  expectSweptBy(all, spline, whole, motion, 2 * kOnCarrier);
  ASSERT_TRUE(all.carrier && all.carrier->sheet);
  EXPECT_EQ(all.carrier->sheet->knotsU().poleCount(), 6U);
  const TestMotion move = lineMotion({1, 2, 30});
  const auto pushed = sweptBy(spline, along, move.path(), kWhole);
  expectSweptBy(pushed, spline, along, move);
  EXPECT_EQ(pushed.carrier->kind, CarrierKind::Extrusion);
}

TEST(SweptCurve, SingularSurfacesAreRefused) {
  // A line through the axis of turning, inclined: the apex of a cone lies in the range.
  const TestMotion turn = screwMotion({0, 0, 0}, {0, 0, 1}, 1.2, 0);
  const Curve through = lineThrough({-5, 0, -5}, {5, 0, 5});
  EXPECT_EQ(sweptBy(through, {0, through.last}, turn.path(), kWhole).why, Degeneracy::Singular);
  // A curve that is parallel to its velocity at one point folds there.
  const Curve arc = circleCurve({0, 0, 0}, {0, 0, 1}, 5);
  TestMotion twist = lineMotion({30, 0, 0});
  twist.to = pose({30, 0, 0}, {1, 0, 0}, 0.3);
  EXPECT_EQ(sweptBy(arc, {0.1, 6.0}, twist.path(), kWhole).why, Degeneracy::Singular);
}

TEST(SweptCurve, TheOutwardSideFollowsTheParametersAndCanBeTurned) {
  const TestMotion motion = generalMotion();
  const Curve line = lineThrough({-20, -12, 0}, {20, -12, 5});
  auto made = sweptBy(line, {0, line.last}, motion.path(), kWhole);
  ASSERT_TRUE(made.carrier);
  const Vector3d p = motion.at(line.at(20), 0.5);
  const Vector3d side = motion.turned(line.axis, 0.5).cross(motion.velocity(line.at(20), 0.5));
  EXPECT_GT(made.carrier->normal(p).dot(side), 0);
  EXPECT_GT(made.carrier->distance(p + 0.1 * side.normalized()), 0);
  faceOutwards(*made.carrier, p, -side);
  EXPECT_LT(made.carrier->normal(p).dot(side), 0);
  EXPECT_NEAR(made.carrier->distance(p + 0.1 * side.normalized()), -0.1, 1e-6);
}

}  // namespace
}  // namespace swept::step
