// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/exact_predicates.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace swept::test {
namespace {

/// Returns the sign of the determinant of b - a, c - a and d - a, computed with 128-bit integers.
/// The coordinates must be integers.
int integerSign(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                const Eigen::Vector3d& d) {
  __extension__ using Wide = __int128;
  Wide m[3][3];
  const Eigen::Vector3d rows[3] = {b - a, c - a, d - a};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) m[i][j] = static_cast<long long>(rows[i][j]);
  }
  const Wide det = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                   m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                   m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  return (det > 0) - (det < 0);
}

TEST(ExactPredicates, AgreeWithIntegersNearThePlane) {
  std::mt19937_64 random(99);
  std::uniform_int_distribution<long long> wide(-(1ll << 36), 1ll << 36);
  std::uniform_int_distribution<int> small(-1, 1);
  int zeros = 0;
  for (int round = 0; round < 20000; ++round) {
    Eigen::Vector3d p[4];
    for (auto& x : p) {
      x = Eigen::Vector3d(double(wide(random)), double(wide(random)), double(wide(random)));
    }
    // The fourth point lies in the plane of the others, and is then moved by at most one lattice
    // step.
    p[3] = p[1] + p[2] - p[0];
    p[3] += Eigen::Vector3d(small(random), small(random), small(random));
    const int expected = integerSign(p[0], p[1], p[2], p[3]);
    zeros += expected == 0;
    ASSERT_EQ(orientation3d(p[0], p[1], p[2], p[3]), expected) << round;
    ASSERT_EQ(orientation3d(p[1], p[0], p[2], p[3]), -expected) << round;
  }
  EXPECT_GT(zeros, 100);
}

TEST(ExactPredicates, OneBitOffTheLine) {
  const Eigen::Vector3d a(0.1, 0.1, 0), b(0.3, 0.3, 0);
  Eigen::Vector3d c(0.7, 0.7, 0);
  EXPECT_EQ(orientation2d(a, b, c, 0, 1), 0);
  c.y() = std::nextafter(0.7, 1);
  EXPECT_EQ(orientation2d(a, b, c, 0, 1), 1);
  EXPECT_FALSE(collinear(a, b, c));
  c.y() = std::nextafter(0.7, 0);
  EXPECT_EQ(orientation2d(a, b, c, 0, 1), -1);
}

TEST(ExactPredicates, SideOfAPlane) {
  const Eigen::Vector3d a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
  EXPECT_EQ(orientation3d(a, b, c, {0.3, 0.3, 1e-300}), 1);
  EXPECT_EQ(orientation3d(a, b, c, {0.3, 0.3, -1e-300}), -1);
  EXPECT_EQ(orientation3d(a, b, c, {0.3, 0.3, 0}), 0);
}

}  // namespace
}  // namespace swept::test
