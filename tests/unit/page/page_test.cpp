// Pages: texts in each language, templates, escaping, positions of parts; and input that is no
// report.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "swept/page.h"

#include <gtest/gtest.h>

#include <set>

#include "page/html.h"
#include "page/layout.h"
#include "page/scene.h"
#include "page/words.h"
#include "support/shapes.h"
#include "swept/clearance.h"
#include "swept/mechanism.h"

namespace swept {
namespace {

using namespace swept::page;
using Eigen::Vector3d;

std::string codeOf(const std::function<void()>& act, const std::string& part) {
  try {
    act();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    return error.code();
  }
  ADD_FAILURE() << "not refused";
  return {};
}

std::set<std::string> marksOf(const std::string& text) {
  std::set<std::string> found;
  for (const char* mark : {"{0}", "{1}"})
    if (text.find(mark) != std::string::npos) found.insert(mark);
  return found;
}

TEST(PageWords, EveryTextIsThereInBothLanguages) {
  std::set<std::string> keys;
  for (const Word& word : allWords()) {
    EXPECT_TRUE(keys.insert(word.key).second) << word.key << " is there twice";
    EXPECT_FALSE(std::string(word.english).empty()) << word.key;
    EXPECT_FALSE(std::string(word.german).empty()) << word.key;
    EXPECT_EQ(marksOf(word.english), marksOf(word.german)) << word.key;
    EXPECT_EQ(std::string(word.german).find("ae"), std::string::npos) << word.german;
  }
  EXPECT_GT(keys.size(), 60u);
  EXPECT_THROW(Words("en")("no such key"), std::logic_error);
  EXPECT_EQ(codeOf([] { Words("fr"); }, "allowed: en, de"), "BadOption");
}

TEST(PageWords, NumbersAndTheirPlaces) {
  EXPECT_EQ(Words("de").millimetres(3.25), "3,25 mm");
  EXPECT_EQ(Words("en").seconds(0.5), "0.5 s");
  EXPECT_EQ(Words("en")("not_met", "2", "12"), "2 of 12 checked pairs do not meet their rules.");
}

TEST(PageLayout, PlaceholdersAreFilledOnceAndUnknownOnesNamed) {
  const std::map<std::string, std::string> values{{"title", "{{table}}"}, {"table", "T"}};
  EXPECT_EQ(filled("<a>{{title}} {{ table }}</a>}}", values), "<a>{{table}} T</a>}}");
  EXPECT_EQ(filled("", values), "");
  EXPECT_EQ(
      codeOf(
          [&] { filled("a\nb {{logo}}", values); },
          "line 2 of the template: {{logo}} is not a placeholder; use one of these: table, title"),
      "BadTemplate");
  EXPECT_EQ(codeOf([&] { filled("{{title", values); }, "{{ has no closing }}"), "BadTemplate");
}

TEST(PageHtml, NothingBecomesMarkup) {
  EXPECT_EQ(escaped("<script>\"a\" & 'b'"), "&lt;script&gt;&quot;a&quot; &amp; &#39;b&#39;");
  EXPECT_EQ(escaped("Gehäuse\n"), "Gehäuse\n");
  EXPECT_EQ(escaped(std::string("a\x01z\x80")), "a\xEF\xBF\xBDz\xEF\xBF\xBD");
  EXPECT_EQ(dataElement("x", {{"a", "</script>&\x80"}}),
            "<script type=\"application/json\" id=\"x\">"
            "{\"a\":\"\\u003c/script\\u003e\\u0026\xEF\xBF\xBD\"}</script>\n");
}

TEST(PageHtml, Base64AsInTheStandard) {  // RFC 4648, section 10
  const std::pair<const char*, const char*> cases[] = {{"", ""},
                                                       {"f", "Zg=="},
                                                       {"fo", "Zm8="},
                                                       {"foo", "Zm9v"},
                                                       {"foob", "Zm9vYg=="},
                                                       {"fooba", "Zm9vYmE="},
                                                       {"foobar", "Zm9vYmFy"}};
  for (const auto& [text, expected] : cases)
    EXPECT_EQ(base64(text, std::string(text).size()), expected);
}

TEST(PageScene, PartsStandWhereTheirMotionHasThem) {
  Trajectory motion;
  motion.pivot = Vector3d(10, 0, 0);
  motion.poses.resize(2);
  motion.poses[1].timeSeconds = 2;
  motion.poses[1].rotation = Eigen::AngleAxisd(0.5 * M_PI, Vector3d::UnitZ());
  motion.poses[1].translation = Vector3d(10, -10, 0);  // the pivot does not move
  for (const double time : {-1.0, 0.0, 0.7, 1.0, 2.0, 9.0}) {
    const Pose pose = poseAt(motion, time);
    EXPECT_LT((pose.rotation * motion.pivot + pose.translation - motion.pivot).norm(), 1e-9);
  }
  EXPECT_NEAR(poseAt(motion, 1).rotation.angularDistance(motion.poses[0].rotation), M_PI / 4, 1e-9);
  motion.interpolation = Interpolation::None;
  EXPECT_EQ(poseAt(motion, 1.99).translation, Vector3d(0, 0, 0));
  EXPECT_EQ(poseAt(motion, 2).translation, Vector3d(10, -10, 0));
}

TEST(Page, ReportsThatAreNoneAreNamed) {
  RunContext run;
  const auto code = [&](const std::string& report, const std::string& part) {
    return codeOf([&] { reportPage(report, {}, run); }, part);
  };
  EXPECT_EQ(code("", "this report cannot be turned into"), "BadReport");
  EXPECT_EQ(code("[]", "it is not a report of version 1"), "BadReport");
  EXPECT_EQ(
      code(R"({"report_version": 1, "command": "check"})", "'clearance', 'mechanism' and 'study'"),
      "BadReport");
  EXPECT_EQ(code(R"({"report_version": 1, "command": "clearance", "status": "Cancelled",
                     "message": "stopped"})",
                 "ended with Cancelled: stopped"),
            "BadReport");
  EXPECT_EQ(code(R"({"report_version": 1, "command": "clearance", "status": "Ok"})", "neighbours"),
            "BadReport");
  EXPECT_EQ(code(R"({"report_version": 1, "command": "clearance", "status": "Ok",
                     "neighbours": [{"name": "a", "verdict": "<b>"}]})",
                 "'<b>' is unknown"),
            "BadReport");
}

TEST(Page, StudiesHaveATableAndAPartForEachRun) {
  RunContext run;
  const std::string head = R"({"report_version": 1, "command": "study", "name": "<doors>",
      "done": 1, "not_clear": 0, "failed": 1, "not_run": 0, "output": "/somewhere", "runs": [)";
  const std::string failed = R"({"run": "b", "state": "failed", "message": "no <poses>"})";
  const std::string done = R"({"run": "a", "state": "done", "page": "a/clearance.html",
      "clearance": {"status": "Ok", "neighbours": [{"name": "post", "verdict": "clear",
        "distance": 5, "guaranteed": 4, "time_seconds": 1, "point_on_body": [0, 0, 0],
        "point_on_neighbour": [5, 0, 0], "curve": [[0, 9], [1, 5]],
        "pose": {"translation": [0, 0, 0], "quaternion_xyzw": [0, 0, 0, 1]}}]}})";
  const std::string page = reportPage(head + failed + "," + done + "]}", {}, run);
  for (const char* part :
       {"1 of 2 runs are done", "&lt;doors&gt;", "no &lt;poses&gt;", "<a href=\"#run-1\">b</a>",
        "<section id=\"run-2\">", "<svg", "<a href=\"a/clearance.html\">open</a>"})
    EXPECT_NE(page.find(part), std::string::npos) << part;
  EXPECT_LT(page.find("no &lt;poses&gt;"), page.find("<svg")) << "in the order of the report";
  EXPECT_EQ(page.find("/somewhere"), std::string::npos) << "the same in every folder";
  EXPECT_EQ(page.find("id=\"graph"), std::string::npos) << "one of several";
  const auto code = [&](const std::string& row, const std::string& part) {
    return codeOf([&] { reportPage(head + row + "]}", {}, run); }, part);
  };
  EXPECT_EQ(code(R"({"run": "a", "state": "late"})", "'late' of a run is unknown"), "BadReport");
  EXPECT_EQ(
      code(R"({"run": "a", "state": "done", "page": "data:x"})", "must be a path relative to"),
      "BadReport");
  EXPECT_EQ(code(R"({"run": "a", "state": "done", "clearance": {"neighbours": 3}})",
                 "this report cannot be turned into"),
            "BadReport");
}

TEST(Page, TheTemplatesAreWholeAndAViewCanBeStopped) {
  const std::string report = R"({"report_version": 1, "command": "clearance", "status": "Ok",
                                 "neighbours": [], "ignored": ["a"]})";
  RunContext run;
  PageOptions options;
  for (const char* name : {"page", "print"}) {
    options.layout = pageTemplate(name);
    EXPECT_NE(reportPage(report, options, run).find("No pair was checked"), std::string::npos);
  }
  const std::string names = "{{data}}{{view}}{{ graph }}";
  EXPECT_NO_THROW(checkPageTemplate(names));
  EXPECT_EQ(codeOf([] { checkPageTemplate("{{logo}}"); }, "{{logo}} is not a placeholder"),
            "BadTemplate");
  // The names that checkPageTemplate() accepts are those that are filled in.
  const auto known = [](const std::function<void()>& act) {
    try {
      act();
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  options.layout = "{{logo}}";
  EXPECT_EQ(known([&] { reportPage(report, options, run); }),
            known([] { checkPageTemplate("{{logo}}"); }));
  options.layout.clear();
  EXPECT_EQ(codeOf([] { pageTemplate("x"); }, "allowed: page, print"), "BadOption");
  if (!pageHasView()) GTEST_SKIP() << "built without three.js";
  options.parts.push_back({"a", test::makeBox(Vector3d(0, 0, 0), Vector3d(1, 1, 1))});
  EXPECT_NE(reportPage(report, options, run).find("id=\"scene\""), std::string::npos);
  run.cancel();
  EXPECT_EQ(codeOf([&] { reportPage(report, options, run); }, ""), "Cancelled");
}

}  // namespace
}  // namespace swept
