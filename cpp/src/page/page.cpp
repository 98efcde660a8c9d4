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
#include "page/words.h"

namespace swept {
namespace page {
namespace {

std::string pageOf(const std::string& report, const PageOptions& options, RunContext& run) {
  const Words words(options.language);
  const Told told = tellReport(report);
  const std::string title = options.title.empty()
                                ? words(told.mechanism ? "title_mechanism" : "title_clearance")
                                : options.title;
  const std::string program =
      "Swept Volume" + (options.version.empty() ? "" : " " + options.version);
  const std::map<std::string, std::string> values{{"language", words.language()},
                                                  {"title", escaped(title)},
                                                  {"date", escaped(options.date)},
                                                  {"version", escaped(options.version)},
                                                  {"made_by", escaped(words("made_by", program))},
                                                  {"style", resourceText("page.css")},
                                                  {"verdict", verdictBanner(told, words)},
                                                  {"table", verdictTable(told, words)},
                                                  {"graph", graphOf(told, words)},
                                                  {"view", viewOf(told, options, words, run)},
                                                  {"pictures", picturesOf(options.pictures, words)},
                                                  {"rules", rulesTable(told, words)},
                                                  {"settings", settingsTable(told, words)},
                                                  {"inputs", inputsTable(options.inputs, words)},
                                                  {"findings", findingsList(told, words)},
                                                  {"data", dataElement("report", told.report)}};
  return filled(options.layout.empty() ? pageTemplate() : options.layout, values);
}

/// What pageOf() fills in.
constexpr std::array kPlaceholders{
    "data",  "date",     "findings", "graph", "inputs", "language", "made_by", "pictures",
    "rules", "settings", "style",    "table", "title",  "verdict",  "version", "view"};

}  // namespace
}  // namespace page

std::string reportPage(const std::string& report, const PageOptions& options, RunContext& run) {
  try {
    return page::pageOf(report, options, run);
  } catch (const Json::exception& error) {
    throw Error(Status::InvalidInput, "BadReport",
                std::string("no page can be made of this report: ") + error.what());
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
