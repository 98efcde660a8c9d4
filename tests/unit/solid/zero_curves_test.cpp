// Zeros of functions of one parameter, against exact ones.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/zero_curves.h"

#include <gtest/gtest.h>

#include <cmath>

namespace swept::step {
namespace {

// Expects the zero of f between the points, in few evaluations, whichever point comes first.
void expectZero(double zero, double from, double to, const OfOne& f, int mostEvaluations) {
  for (const bool isForward : {true, false}) {
    int evaluations = 0;
    const OfOne counted = [&](double t) {
      ++evaluations;
      return f(t);
    };
    const double found =
        isForward ? zeroBetween(counted, from, to) : zeroBetween(counted, to, from);
    EXPECT_NEAR(found, zero, 1e-15 * (to - from));
    EXPECT_LE(evaluations, mostEvaluations);
  }
}

TEST(ZeroBetween, IsExactForSmoothFunctions) {
  expectZero(
      std::cbrt(0.3), 0, 1, [](double t) { return t * t * t - 0.3; }, 16);
  expectZero(
      M_PI, 3, 4, [](double t) { return std::sin(t); }, 16);
}

TEST(ZeroBetween, IsNeverMuchSlowerThanHalving) {
  expectZero(
      0.3, 0, 1, [](double t) { return t < 0.3 ? -1.0 : 1.0; }, 60);
  expectZero(
      0.3, 0, 1, [](double t) { return t < 0.3 ? -1e-9 : 1e9; }, 60);
  expectZero(
      0.3, 0, 1, [](double t) { return std::pow(t - 0.3, 9); }, 60);
}

TEST(ZeroBetween, FindsZerosAtTheEnds) {
  expectZero(
      0, 0, 1, [](double t) { return t; }, 2);
  expectZero(
      2, 1, 2, [](double t) { return t - 2; }, 2);
}

TEST(ZeroBetween, BearsInfiniteValues) {
  expectZero(
      0.3, 0, 1, [](double t) { return t < 0.3 ? -HUGE_VAL : HUGE_VAL; }, 60);
}

}  // namespace
}  // namespace swept::step
