// Texts of a report: the JSON, and the names of statuses, phases and options.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <string>

#include "base/report_json.h"
#include "swept/report.h"
#include "swept/run_context.h"
#include "swept/types.h"

namespace swept {
namespace {

constexpr int kStatuses = static_cast<int>(Status::InternalError) + 1;

TEST(ReportText, BytesThatAreNoTextAreReplaced) {
  const std::string text = jsonText(Json("a \xff \xed\xa0\x80 H\xc3\xbclle"));
  EXPECT_TRUE(Json::accept(text)) << text;
  EXPECT_NE(text.find("H\xc3\xbclle"), std::string::npos);
  EXPECT_NE(text.find("a \xef\xbf\xbd "), std::string::npos);
}

TEST(ReportText, NumbersAreExactAndNeverInfinite) {
  Json json{0.1, -3, std::uint64_t{18446744073709551615U}};
  json.push_back(std::numeric_limits<double>::infinity());
  EXPECT_EQ(jsonText(json), "[\n  0.1,\n  -3,\n  18446744073709551615,\n  null\n]\n");
}

TEST(ReportText, KeysThatDoNotApplyAreAbsent) {
  Report report;
  report.status = Status::InvalidInput;
  report.code = "BadFile";
  report.message = "no file";
  for (const char* key : {"closed", "volume", "cell", "grid", "placements", "chord_error",
                          "conservative_bound", "threads"}) {
    EXPECT_FALSE(reportJson(report).contains(key)) << key;
  }
  report.check.triangles = report.check.vertices = 4;
  report.cellSize = 2;
  EXPECT_TRUE(reportJson(report).contains("volume"));
  EXPECT_TRUE(reportJson(report).contains("grid_origin"));
  EXPECT_FALSE(reportJson(report).contains("self_intersections")) << "not counted";
}

TEST(ReportText, TheReportNamesItsFindings) {
  Report report;
  report.status = Status::InvalidInput;
  report.code = "BadFile";
  report.message = "say \"what\"";
  report.warnings.push_back({"OpenMesh", 2, {0, 7}, "two loops"});
  report.seconds.push_back({"total", 1.5});
  const std::string text = toJson(report);
  for (const char* part :
       {R"("status": "InvalidInput")", R"("code": "BadFile")", R"("message": "say \"what\"")",
        R"("code": "OpenMesh")", R"("total": 1.5)"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << " is not in\n" << text;
  }
}

TEST(ReportText, EveryStatusAndPhaseHasANameOfItsOwn) {
  std::set<std::string> statuses;
  for (int i = 0; i < kStatuses; ++i) statuses.insert(statusName(static_cast<Status>(i)));
  EXPECT_EQ(statuses.size(), static_cast<std::size_t>(kStatuses));
  EXPECT_EQ(statuses.count("?"), 0U);
  EXPECT_STREQ(statusName(static_cast<Status>(kStatuses)), "?");
  std::set<std::string> phases;
  for (int i = 0; i < kPhaseCount; ++i) phases.insert(phaseName(static_cast<Phase>(i)));
  EXPECT_EQ(phases.size(), static_cast<std::size_t>(kPhaseCount));
  EXPECT_EQ(phases.count("?"), 0U);
}

TEST(ReportText, NamesOfOptionsGoBothWays) {
  for (const char* name : {"none", "linear", "screw"}) {
    EXPECT_STREQ(interpolationName(parseInterpolation(name)), name);
  }
  for (const char* name : {"dc", "dmc", "equivalence", "greedy", "consistent"}) {
    EXPECT_STREQ(componentMethodName(parseComponentMethod(name)), name);
  }
  for (const char* name : {"auto", "cpu", "gpu"}) {
    EXPECT_STREQ(backendName(parseBackend(name)), name);
  }
  EXPECT_EQ(parseLengthUnit("in"), 25.4);
  try {
    parseBackend("GPU");
    FAIL() << "names are written small";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), "BadOption");
    EXPECT_STREQ(error.what(), "backend is 'GPU'; allowed: auto, cpu, gpu");
  }
}

}  // namespace
}  // namespace swept
