// SPDX-License-Identifier: LGPL-2.1-or-later
#include "swept/page.h"

#include <array>
#include <map>

#include "page/graph.h"
#include "page/html.h"
#include "page/layout.h"
#include "page/resources.h"
#include "page/rows.h"
#include "page/scene.h"
#include "page/sections.h"
#include "page/study.h"
#include "page/words.h"

namespace swept {
namespace page {
namespace {

using Values = std::map<std::string, std::string>;

Values checkValues(const CheckReport& check, const PageOptions& options, const Words& words,
                   RunContext& run) {
  return {{"title", escaped(words(check.mechanism ? "title_mechanism" : "title_clearance"))},
          {"verdict", verdictBanner(check, words)},
          {"table", verdictTable(check, words)},
          {"graph", graphOf(check, words)},
          {"view", viewOf(check, options, words, run)},
          {"runs", ""},
          {"rules", rulesTable(check, words)},
          {"settings", settingsTable(check, words)},
          {"findings", findingsList(check, words)},
          {"data", dataElement("report", check.report)}};
}

/// Returns the values of the placeholders. The page of a study has no 3D view. Graphs, rules and
/// findings are in the sections of its runs.
Values studyValues(const StudyReport& study, const Words& words) {
  return {{"title", escaped(study.report.value("name", words("title_study")))},
          {"verdict", studyBanner(study, words)},
          {"table", studyTable(study, words)},
          {"graph", ""},
          {"view", ""},
          {"runs", studyRuns(study, words)},
          {"rules", ""},
          {"settings", ""},
          {"findings", ""},
          {"data", dataElement("report", study.report)}};
}

std::string pageOf(const std::string& text, const PageOptions& options, RunContext& run) {
  const Words words(options.language);
  Json report = parseReport(text);
  const bool isStudy = report["command"] == "study";
  Values values = isStudy ? studyValues(readStudy(std::move(report)), words)
                          : checkValues(readCheck(std::move(report)), options, words, run);
  const std::string program =
      "Swept Volume" + (options.version.empty() ? "" : " " + options.version);
  if (!options.title.empty()) values["title"] = escaped(options.title);
  values["language"] = words.language();
  values["date"] = escaped(options.date);
  values["version"] = escaped(options.version);
  values["made_by"] = escaped(words("made_by", program));
  values["style"] = resourceText("page.css");
  values["pictures"] = picturesOf(options.pictures, words);
  values["inputs"] = inputsTable(options.inputs, words);
  return filled(options.layout.empty() ? pageTemplate() : options.layout, values);
}

/// The placeholders that pageOf() fills.
constexpr std::array kPlaceholders{
    "data", "date",     "findings", "graph", "inputs", "language", "made_by", "pictures", "rules",
    "runs", "settings", "style",    "table", "title",  "verdict",  "version", "view"};

}  // namespace
}  // namespace page

std::string reportPage(const std::string& report, const PageOptions& options, RunContext& run) {
  try {
    return page::pageOf(report, options, run);
  } catch (const Json::exception& error) {
    throw Error(
        Status::InvalidInput, "BadReport",
        std::string(
            "this report cannot be turned into an HTML page: it is damaged, or not a report of "
            "this version (") +
            error.what() + "); create the report again");
  }
}

void checkPageTemplate(const std::string& layout) {
  std::map<std::string, std::string> values;
  for (const char* name : page::kPlaceholders) values[name];
  page::filled(layout, values);
}

std::string pageTemplate(const std::string& name) {
  if (name == "page" || name == "print") return page::resourceText(name + ".html");
  throw Error(Status::InvalidInput, "BadOption",
              "template is '" + name + "'; allowed: page, print");
}

bool pageHasView() { return *page::resourceText("view") != '\0'; }

}  // namespace swept
