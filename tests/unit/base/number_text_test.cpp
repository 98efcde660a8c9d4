// Texts of numbers, compared with those of the C library in the locale "C".
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/number_text.h"

#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace swept::test {
namespace {

std::string printed(const char* format, int digits, double value) {
  char text[512];
  std::snprintf(text, sizeof text, format, digits, value);
  return text;
}

TEST(NumberText, AsPrintfHasIt) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> exponent(-320, 308), mantissa(-10, 10);
  std::vector<double> values{0, -0.0, 1, 0.5, -2.5, 1e9, 999999.5, DBL_MAX, DBL_MIN, 5e-324};
  while (values.size() < 2000) {
    values.push_back(mantissa(random) * std::pow(10, exponent(random)));
  }
  for (const double value : values) {
    for (const int digits : {1, 3, 6, kTellingDigits}) {
      EXPECT_EQ(numberText(value, digits), printed("%.*g", digits, value));
      EXPECT_EQ(fixedText(value, digits), printed("%.*f", digits, value));
    }
  }
}

TEST(NumberText, OneAndMany) {
  EXPECT_EQ(counted(0, "edge"), "0 edges");
  EXPECT_EQ(counted(1, "edge"), "1 edge");
  EXPECT_EQ(counted(2, "edge"), "2 edges");
  EXPECT_EQ(counted(1, "vertex has", "vertices have"), "1 vertex has");
  EXPECT_EQ(counted(12, "vertex has", "vertices have"), "12 vertices have");
}

TEST(NumberText, PartsOneAfterTheOther) {
  const std::string name = "a part";
  std::ostringstream expected;
  expected.precision(4);
  expected << name << " of " << 0.123456 << " mm, " << std::int64_t{-5} << " of " << std::size_t{7}
           << 'x' << 1234567.0F;
  EXPECT_EQ(textOf(4, name, " of ", 0.123456, " mm, ", std::int64_t{-5}, " of ", std::size_t{7},
                   "x", 1234567.0F),
            expected.str());
}

}  // namespace
}  // namespace swept::test
