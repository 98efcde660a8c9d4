// Tests of B-splines and of sheets (surfaces made of B-splines). Values are compared with
// polynomials and with the exact surface at dense samples. Also tested: parts cut from curves and
// sheets.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/carrier/sheet.h"

#include <gtest/gtest.h>

#include <cmath>

#include "solid/sweep/interpolate.h"

namespace swept::step {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kMostPoles = 1000;

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
      {-1, 1}, {0, 2}, nullptr, bound, kMostPoles);
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
                        {-1, 1}, {0, 1}, nullptr, 1e-8, kMostPoles));
  EXPECT_FALSE(fitSheet([](double u, double t) { return Vector3d(u, t, std::sqrt(u)); }, {-1, 1},
                        {0, 1}, nullptr, 1e-8, kMostPoles));
}

TEST(Sheet, PartsLieOnIt) {
  const auto sheet = wavy().sheet;
  const Sheet part = sheet->part({-0.4, 0.77}, {0.2, 1.9});
  for (int i = 0; i <= 10; ++i) {
    for (int j = 0; j <= 10; ++j) {
      const double u = -0.4 + 0.117 * i, t = 0.2 + 0.17 * j;
      ASSERT_LE((part.at(u, t) - sheet->at(u, t)).norm(), 1e-12);
    }
  }
}

}  // namespace
}  // namespace swept::step
