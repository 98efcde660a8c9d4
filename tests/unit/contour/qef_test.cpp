// The vertex for the planes of a component: no point of the cell has a smaller quadratic error, and
// inexact planes do not move the vertex far.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/qef.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

namespace swept::test {
namespace {

using V3 = Eigen::Vector3d;

TEST(Qef, NoPlaceInTheCellIsBetter) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> fraction(0, 1), sign(-1, 1);
  constexpr double kMargin = 1e-4;
  for (int n = 0; n < 300; ++n) {
    Qef planes;
    const V3 about = V3(sign(random), sign(random), sign(random));
    for (int p = 0; p < 3 + n % 4; ++p) {
      const V3 turn(sign(random), sign(random), sign(random));
      planes.add(V3(fraction(random), fraction(random), fraction(random)),
                 (about + turn).normalized());
    }
    V3 free;
    const V3 best = planes.solve(kMargin, free);
    EXPECT_GE(best.minCoeff(), kMargin - 1e-11);
    EXPECT_LE(best.maxCoeff(), 1 - kMargin + 1e-11);
    const auto error = [&](const V3& x) {
      return planes.error(x) +
             Qef::kDamping * planes.count() * (x - planes.massPoint()).squaredNorm();
    };
    for (int k = 0; k < 200; ++k) {
      const V3 x = V3(fraction(random), fraction(random), fraction(random)) * (1 - 2 * kMargin);
      EXPECT_GE(error(x + V3::Constant(kMargin)), error(best) - 1e-9);
    }
  }
}

/// Planes whose normals differ by a tenth of a degree and whose positions differ by a few
/// hundredths of a cell.
TEST(Qef, DampingKeepsPlanesThatAreNearlyOneAtTheirPlaces) {
  Qef planes;
  const auto add = [&](double x, double y, double z, double turn) {
    planes.add({x, y, z}, V3(turn, -turn / 2, 1).normalized());
  };
  add(0, 0, 0.50, 0);
  add(1, 0, 0.53, 0.002);
  add(0, 1, 0.53, 0.001);
  add(1, 1, 0.50, -0.001);
  V3 free;
  const V3 middle(0.5, 0.5, 0.515);
  EXPECT_GT((planes.solve(1e-4, free) - middle).norm(), 0.3);
  EXPECT_LT((planes.solve(1e-4, 0.002, free) - middle).norm(), 0.02);
}

}  // namespace
}  // namespace swept::test
