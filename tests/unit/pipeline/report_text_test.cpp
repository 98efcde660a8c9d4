// What people and programs read: the report as JSON, the names of statuses, phases and options.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <string>

#include "base/json_writer.h"
#include "swept/report.h"
#include "swept/run_context.h"
#include "swept/types.h"

namespace swept {
namespace {

constexpr int kStatuses = static_cast<int>(Status::InternalError) + 1;

std::string quoted(const std::string& text) { return JsonWriter().value(text).text(); }

TEST(ReportText, StringsAreValidJsonWhateverTheBytes) {
  EXPECT_EQ(quoted("a \"b\" \\ c"), R"("a \"b\" \\ c")");
  EXPECT_EQ(quoted(std::string("\n\t\0\x1f", 4)), R"("\n\u0009\u0000\u001f")");
  EXPECT_EQ(quoted("H\xc3\xbclle \xe2\x82\xac \xf0\x9f\x98\x80"),
            "\"H\xc3\xbclle \xe2\x82\xac \xf0\x9f\x98\x80\"");
  const std::string replaced = "\xef\xbf\xbd";
  EXPECT_EQ(quoted("\xff"), '"' + replaced + '"');
  EXPECT_EQ(quoted("\xc3"), '"' + replaced + '"') << "cut off";
  EXPECT_EQ(quoted("\xc0\x80"), '"' + replaced + replaced + '"') << "longer than it need be";
  EXPECT_EQ(quoted("\xed\xa0\x80"), '"' + replaced + replaced + replaced + '"') << "a surrogate";
  EXPECT_EQ(quoted("\xf4\x90\x80\x80"), '"' + replaced + replaced + replaced + replaced + '"');
}

TEST(ReportText, NumbersAreExactAndNeverInfinite) {
  JsonWriter json;
  json.beginArray().value(0.1).value(-3).value(std::uint64_t{18446744073709551615U});
  json.value(std::numeric_limits<double>::infinity()).value(true).value(false).endArray();
  EXPECT_EQ(json.text(), "[\n  0.1,\n  -3,\n  18446744073709551615,\n  null,\n  true,\n  false\n]");
  EXPECT_EQ(JsonWriter().beginObject().endObject().text(), "{}");
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
