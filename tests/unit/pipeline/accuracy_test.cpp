// A run with an accuracy in mm: it chooses cell size, tolerance and chord error, and the report
// has a bound on the total error.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "swept/accuracy.h"

#include <gtest/gtest.h>

#include "support/shapes.h"
#include "swept/compute.h"

namespace swept::test {
namespace {

/// A box that moves along a diagonal and turns.
Result boxWithin(double accuracy, double offset = 0) {
  Trajectory motion;
  motion.poses = {
      {}, {1, Eigen::Quaterniond(Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ())), {12, 5, 3}}};
  Options options;
  options.offset = offset;
  setAccuracy(options, accuracy);
  RunContext run;
  return compute(makeBox({-4, -2, -1}, {4, 2, 1}), motion, options, run);
}

TEST(Accuracy, ReportBoundsWhatWasLost) {
  for (const double accuracy : {1.0, 0.3}) {
    const Report report = boxWithin(accuracy).report;
    ASSERT_EQ(report.status, Status::Ok) << report.message;
    const double bound = accuracyBound(report).value();
    EXPECT_LE(bound, accuracy);
    EXPECT_GE(bound, report.cellSize + report.chordError + report.simplificationDeviation);
    EXPECT_GT(report.simplificationDeviation, 0);
    EXPECT_NE(toJson(report).find("\"accuracy_bound\""), std::string::npos);
  }
}

TEST(Accuracy, NoBoundForGrownEnvelopes) {
  const Report report = boxWithin(1, 2).report;
  ASSERT_EQ(report.status, Status::Ok) << report.message;
  EXPECT_FALSE(accuracyBound(report).has_value());
  EXPECT_EQ(toJson(report).find("\"accuracy_bound\""), std::string::npos);
}

TEST(Accuracy, RefusesWhatIsNotAbove0) {
  for (const double accuracy : {0.0, -1.0, HUGE_VAL, std::nan("")}) {
    Options options;
    try {
      setAccuracy(options, accuracy);
      FAIL() << accuracy;
    } catch (const Error& error) {
      EXPECT_STREQ(error.code().c_str(), "BadOption");
    }
    EXPECT_FALSE(options.cellSize.has_value());
  }
}

TEST(Accuracy, RefusalsNameTheAccuracyThatFits) {
  const Report coarse = boxWithin(30).report;
  EXPECT_EQ(coarse.code, "CellTooLarge");
  EXPECT_NE(coarse.message.find("at most 2 mm (an accuracy of 4 mm)"), std::string::npos)
      << coarse.message;
  EXPECT_EQ(boxWithin(4).report.status, Status::Ok);
  const Report fine = boxWithin(1e-4).report;
  EXPECT_EQ(fine.code, "ResourceLimit");
  EXPECT_NE(fine.message.find(" mm (an accuracy of "), std::string::npos) << fine.message;
}

}  // namespace
}  // namespace swept::test
