// Tests of B-splines and of sheets (surfaces made of B-splines). Values are compared with
// polynomials and with the exact surface at dense samples, derivatives with finite differences.
// Also tested: parts cut from curves and sheets, and the curves in which sheets intersect other
// surfaces.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/carrier/sheet.h"

#include <gtest/gtest.h>

#include "solid/carrier/section.h"
#include "solid/sweep/borders.h"
#include "solid/sweep/interpolate.h"
#include "solid/sweep/motions.h"

namespace swept::step {
namespace {

TEST(BSpline, InterpolationReproducesPolynomialsOfItsDegree) {
  for (int degree = 1; degree <= 5; ++degree) {
    const Knots knots(degree, {-1, -0.2, 0.1, 2});
    EXPECT_EQ(knots.poleCount(), static_cast<std::size_t>(degree) + 3);
    const auto value = [&](double x) { return std::pow(x - 0.3, degree) + 2; };
    Eigen::MatrixXd values(knots.poleCount(), 1);
    for (std::size_t i = 0; i < knots.poleCount(); ++i)
      values(static_cast<Eigen::Index>(i), 0) = value(knots.sites()[i]);
    const Eigen::MatrixXd poles = Interpolator(knots).poles(values);
    for (const double x : {-1.3, -1.0, -0.5, 0.0, 0.1, 1.3, 2.0, 2.1}) {
      EXPECT_NEAR(valueOf(knots, poles, x)(0), value(x), 1e-10) << degree;
      EXPECT_NEAR(valueOf(knots, poles, x, 1)(0), degree * std::pow(x - 0.3, degree - 1), 1e-9);
      EXPECT_NEAR(valueOf(knots, poles, x, 2)(0),
                  degree == 1 ? 0 : degree * (degree - 1) * std::pow(x - 0.3, degree - 2), 1e-8);
    }
  }
}

TEST(BSpline, APartIsTheSameCurve) {
  const auto fitted = fitSpline(
      [](double v) { return Vector3d(std::cos(3 * v), std::sin(2 * v), v * v); }, {0.5, 2.5}, 1e-8);
  ASSERT_TRUE(fitted);
  EXPECT_EQ(fitted->degree, 5);
  const Curve cubic = splineAlong({{0, 0, 0}, {1, 1, 0}, {3, 1, 1}, {4, 0, 2}},
                                  {{1, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 0, 1}});
  for (const Curve& curve : {*fitted, cubic}) {
    for (const auto& [from, to] : {std::pair(0.0, 1.0), {0.2, 0.7}, {0.31, 1.0}, {0.0, 0.05}}) {
      const Curve part = partOf(curve, from * curve.last, to * curve.last);
      EXPECT_EQ(part.poles.size(), part.degree + 1 + part.joints * (part.knots.size() - 2));
      for (int i = 0; i <= 30; ++i) {
        const double t = from * curve.last + (to - from) * curve.last * i / 30;
        ASSERT_LE((part.at(part.last * i / 30) - curve.at(t)).norm(), 1e-12);
      }
    }
  }
}

FittedSheet wavy(double bound = 1e-8) {
  const auto fitted = fitSheet(
      [](double u, double t) {
        return Vector3d(20 * u, 15 * t + 2 * u, 3 * std::sin(2 * u + t) + t * t);
      },
      {-1, 1}, {0, 2}, nullptr, bound);
  EXPECT_TRUE(fitted);
  return fitted.value_or(FittedSheet{});
}

TEST(Sheet, FollowsTheExactSurfaceBetweenItsSites) {
  for (const double bound : {1e-4, 1e-8}) {
    const FittedSheet fitted = wavy(bound);
    ASSERT_TRUE(fitted.sheet);
    double largest = 0;
    for (int i = 0; i <= 60; ++i) {
      for (int j = 0; j <= 60; ++j) {
        const double u = -1 + i / 30.0, t = j / 30.0;
        const Vector3d truth(20 * u, 15 * t + 2 * u, 3 * std::sin(2 * u + t) + t * t);
        largest = std::max(largest, (fitted.sheet->at(u, t) - truth).norm());
      }
    }
    EXPECT_LE(largest, 1.5 * bound);
    EXPECT_LE(largest, 3 * fitted.error);
  }
  // A sheet can follow neither a kink nor an infinite slope.
  EXPECT_FALSE(fitSheet([](double u, double t) { return Vector3d(u, t, std::abs(u - 0.123)); },
                        {-1, 1}, {0, 1}, nullptr, 1e-8));
  EXPECT_FALSE(fitSheet([](double u, double t) { return Vector3d(u, t, std::sqrt(u)); }, {-1, 1},
                        {0, 1}, nullptr, 1e-8));
}

TEST(Sheet, FootPointsDistancesAndNormals) {
  const auto sheet = wavy().sheet;
  for (const double u : {-1.0, -0.63, 0.0, 0.4, 1.0}) {
    for (const double t : {0.0, 0.31, 1.2, 2.0}) {
      const Sheet::Foot truth = sheet->footAt(u, t);
      constexpr double h = 1e-6;
      EXPECT_LE((truth.alongU - (sheet->at(u + h, t) - sheet->at(u - h, t)) / (2 * h)).norm(),
                1e-6);
      EXPECT_LE((truth.alongT - (sheet->at(u, t + h) - sheet->at(u, t - h)) / (2 * h)).norm(),
                1e-6);
      for (const double off : {-3.0, -0.1, 0.0, 1e-6, 0.5, 4.0}) {
        const Vector3d p = truth.at + off * truth.normal();
        const Sheet::Foot foot = sheet->foot(p);
        EXPECT_NEAR(foot.u, u, 1e-8);
        EXPECT_NEAR(foot.t, t, 1e-8);
        EXPECT_NEAR(sheet->distance(p), off, 1e-9);
        EXPECT_LE((sheet->normal(p) - truth.normal()).norm(), 1e-7);
      }
    }
  }
  // Far beyond its borders the distance is that of the nearest point.
  const Vector3d far(100, 0, 0);
  double nearest = 1e300;
  for (int i = 0; i <= 400; ++i) {
    for (int j = 0; j <= 400; ++j) {
      nearest =
          std::min(nearest, (sheet->at(-1.1 + 2.2 * i / 400, -0.1 + 2.2 * j / 400) - far).norm());
    }
  }
  EXPECT_NEAR(std::abs(sheet->distance(far)), nearest, 0.05);
}

TEST(Sheet, PartsAndIsoCurvesLieOnIt) {
  const auto sheet = wavy().sheet;
  const Sheet part = sheet->part({-0.4, 0.77}, {0.2, 1.9});
  for (int i = 0; i <= 10; ++i) {
    for (int j = 0; j <= 10; ++j) {
      const double u = -0.4 + 0.117 * i, t = 0.2 + 0.17 * j;
      ASSERT_LE((part.at(u, t) - sheet->at(u, t)).norm(), 1e-12);
    }
  }
  const Curve alongT = isoCurve(*sheet, true, 0.3, {0.1, 1.7});
  const Curve alongU = isoCurve(*sheet, false, 0.9, {-0.8, 0.9});
  for (int i = 0; i <= 20; ++i) {
    ASSERT_LE((alongT.at(alongT.last * i / 20) - sheet->at(0.3, 0.1 + 0.08 * i)).norm(), 1e-12);
    ASSERT_LE((alongU.at(alongU.last * i / 20) - sheet->at(-0.8 + 0.085 * i, 0.9)).norm(), 1e-12);
  }
}

Carrier carrying(const std::shared_ptr<const Sheet>& sheet) {
  Carrier carrier;
  carrier.kind = CarrierKind::Sheet;
  carrier.sheet = sheet;
  return carrier;
}

void expectSection(const Carrier& a, const Carrier& b, const std::vector<Vector3d>& along,
                   std::size_t mostPoles) {
  const auto curve = sectionCurve(along, false, a, b, 5);
  ASSERT_TRUE(curve);
  EXPECT_LE(curve->poles.size(), mostPoles);
  for (int i = 0; i <= 1000; ++i) {
    const Vector3d p = curve->at(curve->last * i / 1000);
    ASSERT_LE(std::abs(a.distance(p)), 1e-7);
    ASSERT_LE(std::abs(b.distance(p)), 1e-7);
  }
}

// Returns the point on both carriers near p.
Vector3d onBoth(const Vector3d& p, const Carrier& a, const Carrier& b) {
  return meetingPoint(p, {&a, &b});
}

TEST(Sheet, SectionsWithPlanesCylindersAndSheets) {
  const Carrier sheet = carrying(wavy().sheet);
  const Carrier plane = carrierOf(CarrierKind::Plane, {0, 15, 0}, {0.2, 1, 0.3});
  const Carrier tube = carrierOf(CarrierKind::Cylinder, {0, 15, 0}, {0.1, 0.2, 1}, 8);
  expectSection(sheet, plane,
                {onBoth({-15, 15, 0}, sheet, plane), onBoth({0, 15, 3}, sheet, plane),
                 onBoth({15, 12, 3}, sheet, plane)},
                40);
  expectSection(sheet, tube,
                {onBoth({8, 15, 4}, sheet, tube), onBoth({6, 21, 4}, sheet, tube),
                 onBoth({0, 23, 4}, sheet, tube)},
                60);
  const auto other =
      fitSheet([](double u, double t) { return Vector3d(12 * u, 8 + u * u + t, 12 * t - 4); },
               {-1, 1}, {0, 1}, nullptr, 1e-8);
  ASSERT_TRUE(other);
  const Carrier wall = carrying(other->sheet);
  expectSection(sheet, wall,
                {onBoth({-9, 9, 0}, sheet, wall), onBoth({0, 8, 1}, sheet, wall),
                 onBoth({9, 9, 3}, sheet, wall)},
                60);
}

TEST(Sheet, SectionsThatTouchAreRefused) {
  const auto sheet = wavy().sheet;
  const Sheet::Foot foot = sheet->footAt(0.1, 1.0);
  const Carrier touching = carrierOf(CarrierKind::Plane, foot.at, foot.normal());
  EXPECT_FALSE(sectionCurve({sheet->at(-0.5, 1.0), sheet->at(0.5, 1.0)}, false, carrying(sheet),
                            touching, 5));
}

}  // namespace
}  // namespace swept::step
