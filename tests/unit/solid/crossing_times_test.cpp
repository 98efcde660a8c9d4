// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/crossing_times.h"

#include <gtest/gtest.h>

#include <cmath>

namespace swept::step {
namespace {

// A straight edge along z that moves along a loop. The loop passes through the origin at the times
// 0.22 and 0.78.
Eigen::Vector3d onLoop(double u, double s) {
  const double angle = 2 * M_PI * (0.05 + 0.9 * s);
  return {std::sin(2 * angle), std::cos(angle), u};
}

TEST(CrossingTimes, LieBetweenTheTwoPasses) {
  const std::vector<double> times = crossingTimes(onLoop, {0, 3}, {});
  ASSERT_EQ(times.size(), 1u);
  EXPECT_GT(times[0], 0.22);
  EXPECT_LT(times[0], 0.78);
}

TEST(CrossingTimes, NoneAreNeededWhereTheSurfaceIsCutAlready) {
  EXPECT_TRUE(crossingTimes(onLoop, {0, 3}, {0.4}).empty());
  EXPECT_EQ(crossingTimes(onLoop, {0, 3}, {0.1}).size(), 1u) << "before both passes";
}

TEST(CrossingTimes, NoneWithoutACrossing) {
  const auto arc = [](double u, double s) -> Eigen::Vector3d {
    return {std::cos(3 * s), std::sin(3 * s), u};
  };
  EXPECT_TRUE(crossingTimes(arc, {0, 3}, {}).empty());
}

// Two loops after each other.
TEST(CrossingTimes, OneForEachLoop) {
  const auto loops = [](double u, double s) {
    const double part = std::fmod(2 * s, 1.0);
    Eigen::Vector3d p = onLoop(u, part);
    p.x() += s < 0.5 ? 0 : 5;
    return p;
  };
  const std::vector<double> times = crossingTimes(loops, {0, 3}, {});
  ASSERT_EQ(times.size(), 2u);
  EXPECT_NEAR(times[1] - times[0], 0.5, 0.1);
}

}  // namespace
}  // namespace swept::step
