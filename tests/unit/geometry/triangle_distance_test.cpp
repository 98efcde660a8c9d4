// Distances of points and triangles, compared with sampling and with the definition in long
// double.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/triangle_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/random_numbers.h"

namespace swept::test {
namespace {

using Eigen::Vector3d;
using LongVector = Eigen::Matrix<long double, 3, 1>;

/// Returns the distance by definition: that of the foot of the perpendicular if it lies within the
/// edges, otherwise that of the nearest edge.
double distanceByDefinition(const Vector3d& p, const Triangle3d& triangle) {
  LongVector x = p.cast<long double>(), c[3];
  for (int k = 0; k < 3; ++k) c[k] = triangle[k].cast<long double>();
  long double best = INFINITY;
  for (int k = 0; k < 3; ++k) {
    const LongVector edge = c[(k + 1) % 3] - c[k], away = x - c[k];
    const long double length = edge.squaredNorm();
    const long double s = length > 0 ? std::clamp(edge.dot(away) / length, 0.0L, 1.0L) : 0.0L;
    best = std::min(best, (away - s * edge).norm());
  }
  const LongVector n = (c[1] - c[0]).cross(c[2] - c[0]);
  if (n.squaredNorm() > 0) {
    const LongVector foot = x - n * (n.dot(x - c[0]) / n.squaredNorm());
    bool within = true;
    for (int k = 0; k < 3; ++k) {
      within = within && n.dot((c[(k + 1) % 3] - c[k]).cross(foot - c[k])) >= 0;
    }
    if (within) best = std::min(best, (x - foot).norm());
  }
  return static_cast<double>(best);
}

/// Returns the distance of a point from the triangle on which it should lie.
double distanceFromItself(const Vector3d& point, const Triangle3d& triangle) {
  return distanceByDefinition(point, triangle);
}

TEST(TriangleDistance, PointsAgreeWithTheDefinition) {
  Random random(3);
  for (int n = 0; n < 20000; ++n) {
    const Triangle3d t{random.point(1), random.point(1), random.point(1)};
    const Vector3d p = n % 2 == 0 ? random.point(2) : random.point(1e3);
    const Foot foot = footOnTriangle(p, t);
    const double expected = distanceByDefinition(p, t);
    ASSERT_NEAR(foot.offset.norm(), expected, 1e-11 * (1 + expected)) << n;
    ASSERT_EQ(squaredDistance(p, t[0], t[1], t[2]), foot.offset.squaredNorm());
    ASSERT_NEAR((foot.point + foot.offset - p).norm(), 0, 1e-12 * (1 + p.norm()));
    ASSERT_LT(distanceFromItself(foot.point, t), 1e-12) << n;
  }
}

// The heights of the triangles range from a thousandth of the longest edge down to zero. Rounding
// moves the corners of such a needle by about 1e-16. Even so, the point that is found must lie on
// the needle, and must be as near as the nearest point, both within the limits below.
TEST(TriangleDistance, NeedlesAndPointsAgreeWithTheDefinition) {
  Random random(5);
  for (int n = 0; n < 20000; ++n) {
    const Vector3d a = random.point(1), b = random.point(1);
    const double height = n % 5 == 0 ? 0 : std::pow(10.0, random.number(-17, -3));
    Triangle3d t{a, b, a + random.number(-0.2, 1.2) * (b - a) + height * random.point(1)};
    if (n % 17 == 0) t[1] = t[0];
    if (n % 51 == 0) t[2] = t[0];
    std::rotate(t.begin(), t.begin() + n % 3, t.end());
    const Vector3d p = n % 2 == 0 ? random.point(2) : a + random.point(1e-3);
    const double expected = distanceByDefinition(p, t);
    const Foot foot = footOnTriangle(p, t);
    ASSERT_NEAR(foot.offset.norm(), expected, 2e-8) << n << " height " << height;
    ASSERT_LT(distanceFromItself(foot.point, t), 2e-8) << n;
  }
}

// Returns the smallest distance of the points of a fine grid on triangle a from triangle b: an
// upper bound of the distance of the two triangles.
double sampledDistance(const Triangle3d& a, const Triangle3d& b, int steps) {
  double best = 1e300;
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; i + j <= steps; ++j) {
      const double u = double(i) / steps;
      const double v = double(j) / steps;
      const Vector3d x = a[0] + u * (a[1] - a[0]) + v * (a[2] - a[0]);
      best = std::min(best, (x - footOnTriangle(x, b).point).norm());
    }
  }
  return best;
}

TEST(TriangleDistance, AgreesWithSampling) {
  Random random(1);
  for (int k = 0; k < 400; ++k) {
    Triangle3d a{random.point(1), random.point(1), random.point(1)};
    Triangle3d b{random.point(1), random.point(1), random.point(1)};
    const Vector3d shift = random.point(1.5);
    for (Vector3d& x : b) x += shift;
    if (k % 4 == 1)
      b[1].z() = b[2].z() = b[0].z(), a[1].z() = a[2].z() = a[0].z();  // parallel faces
    if (k % 4 == 2) b[1] = b[0] + (a[1] - a[0]);                       // parallel edges
    if (k % 4 == 3) b[2] = 0.5 * (b[0] + b[1]);                        // a needle
    const NearestPoints p = nearestPoints(a, b);
    const double d = std::sqrt(p.squared);
    EXPECT_NEAR((p.a - p.b).norm(), d, 1e-12);
    EXPECT_NEAR((footOnTriangle(p.a, a).point - p.a).norm(), 0, 1e-9);
    EXPECT_NEAR((footOnTriangle(p.b, b).point - p.b).norm(), 0, 1e-9);
    const double sampled = std::min(sampledDistance(a, b, 60), sampledDistance(b, a, 60));
    EXPECT_LE(d, sampled + 1e-12) << k;
    EXPECT_GE(d, sampled - 0.08) << k;  // the grid divides edges of up to 3.5 by 60
  }
}

TEST(TriangleDistance, ZeroWhereTheyMeet) {
  const Triangle3d a{Vector3d(0, 0, 0), Vector3d(2, 0, 0), Vector3d(0, 2, 0)};
  const Triangle3d through{Vector3d(0.5, 0.5, -1), Vector3d(0.5, 0.5, 1), Vector3d(3, 3, 0)};
  const Triangle3d touching{Vector3d(0.5, 0.5, 0), Vector3d(0.5, 0.5, 1), Vector3d(3, 3, 1)};
  const Triangle3d flatOverlap{Vector3d(0.2, 0.2, 0), Vector3d(0.4, 0.2, 0), Vector3d(0.2, 0.4, 0)};
  for (const Triangle3d& b : {through, touching, flatOverlap}) {
    EXPECT_EQ(nearestPoints(a, b).squared, 0);
    EXPECT_EQ(nearestPoints(b, a).squared, 0);
  }
}

}  // namespace
}  // namespace swept::test
