// The findings that a user gets from the report of a solid.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/solid_findings.h"

#include <gtest/gtest.h>

namespace swept {
namespace {

WrittenSolid reportOf(double tolerance, double deviation) {
  WrittenSolid report;
  report.tolerance = tolerance;
  report.deviation = deviation;
  report.volume = 99;
  report.meshVolume = 100;
  return report;
}

TEST(SolidFindings, ADeviationAboveTheToleranceIsInaccurate) {
  SolidOptions options;
  options.tolerance = 0.5;
  const auto found = solidFindings(reportOf(0.5, 0.51), options);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].code, "SolidInaccurate");
  EXPECT_NE(found[0].text.find("0.51 mm"), std::string::npos) << found[0].text;
  EXPECT_NE(found[0].text.find("such as 0.25 mm"), std::string::npos) << found[0].text;
  EXPECT_TRUE(solidFindings(reportOf(0.5, 0.5), options).empty());
}

TEST(SolidFindings, AToleranceThatTheLimitsChoseIsNamed) {
  const SolidOptions exact;
  EXPECT_TRUE(solidFindings(reportOf(0, 0), exact).empty());
  const auto found = solidFindings(reportOf(0.5, 0.4), exact);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].code, "SolidSimplified");
  EXPECT_NE(found[0].text.find("-1 %"), std::string::npos) << found[0].text;
}

}  // namespace
}  // namespace swept
