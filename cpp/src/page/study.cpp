// SPDX-License-Identifier: LGPL-2.1-or-later
#include "page/study.h"

#include <array>

#include "base/number_text.h"
#include "page/graph.h"
#include "page/html.h"
#include "page/sections.h"

namespace swept::page {
namespace {

using Cells = std::vector<std::vector<std::string>>;

/// A state of a run: its name in a report (`name`), its key in Words (`key`), and the class of its
/// mark (`kind`).
struct State {
  const char *name, *key, *kind;
};
constexpr std::array kStates{
    State{"failed", "failed", "clash"}, State{"not clear", "not_clear", "below"},
    State{"not run", "not_run", "ignored"}, State{"done", "done", "clear"}};

const State& stateOf(const Json& row) {
  const std::string name = row.at("state").get<std::string>();
  for (const State& state : kStates)
    if (name == state.name) return state;
  badReport("the state '" + name + "' of a run is unknown; create the report again");
}

std::string stateMark(const Json& row, const Words& words) {
  const State& state = stateOf(row);
  return element("span", escaped(words(state.key)), std::string("verdict ") + state.kind);
}

std::string anchorOf(std::size_t run) { return textOf(kTellingDigits, "run-", run + 1); }

std::string linkTo(const std::string& address, const std::string& text) {
  return std::string("<a href=\"").append(escaped(address)).append("\">").append(escaped(text)) +
         "</a>";
}

/// Returns the address of a run's own page, inside the folder of the study's page. Throws
/// Error(InvalidInput, "BadReport") for any other address: a page must not link to other places.
std::string pageOf(const Json& row) {
  const std::string address = row.value("page", "");
  if (address.find(':') != std::string::npos || address.starts_with("/"))
    badReport("the key 'page' of a run is '" + address +
              "'; it must be a path relative to the folder of the study's page");
  return address;
}

/// Returns the table without the columns that are empty below their heading.
std::string tableOf(const Cells& cells, const std::string& columns) {
  Cells kept(cells.size());
  std::string kinds;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    bool hasContent = false;
    for (std::size_t i = 1; i < cells.size(); ++i) hasContent = hasContent || !cells[i][k].empty();
    if (!hasContent) continue;
    kinds += columns[k];
    for (std::size_t i = 0; i < cells.size(); ++i) kept[i].push_back(cells[i][k]);
  }
  return table(kept, kinds);
}

std::string linkToRun(const StudyReport& study, std::size_t run) {
  return linkTo(std::string("#").append(anchorOf(run)),
                study.runs[run].row.at("run").get<std::string>());
}

std::string headOf(const Json& row, const Words& words) {
  std::string out = element("p", stateMark(row, words));
  if (row.contains("message"))
    out += element("p", escaped(row["message"].get<std::string>()), "message");
  constexpr int kDigits = 9;
  std::string made;
  if (row.contains("volume"))
    made = words("volume") + ": " + words.number(lengthOf(row, "volume"), kDigits) + " mm³";
  for (const char* key : {"triangles", "faces"})
    if (row.contains(key))
      made.append(made.empty() ? "" : ", ")
          .append(words(key == std::string("faces") ? "faces" : "envelope_triangles"))
          .append(": ")
          .append(words.number(lengthOf(row, key), kDigits));
  if (!made.empty()) out += element("p", escaped(made));
  const std::string page = pageOf(row);
  if (!page.empty()) out += element("p", linkTo(page, words("own_page")));
  return out + "\n";
}

std::string partOf(const char* heading, const std::string& content, const Words& words) {
  return content.empty() ? "" : element("h3", escaped(words(heading))) + "\n" + content + "\n";
}

}  // namespace

StudyReport readStudy(Json report) {
  StudyReport study;
  for (const char* key : {"seconds", "kept", "output"}) report.erase(key);
  for (Json& row : report.at("runs")) {
    StudyRun run;
    if (row.contains("clearance")) {
      Json own = std::move(row["clearance"]);
      own["report_version"] = report["report_version"];
      own["command"] = "clearance";
      run.clearance = readCheck(std::move(own));
    }
    run.row = row;
    run.row.erase("clearance");
    stateOf(run.row);
    if (run.clearance) row["clearance"] = run.clearance->report;
    study.runs.push_back(std::move(run));
  }
  study.report = std::move(report);
  return study;
}

std::string studyBanner(const StudyReport& study, const Words& words) {
  const std::size_t all = study.runs.size();
  std::string counts;
  for (const State& state : kStates)
    counts.append(counts.empty() ? "" : ", ")
        .append(words(state.key) + ": " + words.number(lengthOf(study.report, state.key)));
  const double good = lengthOf(study.report, "done");
  const bool isGood = good == double(all);
  const std::string text = all == 1 && isGood ? words("one_run_good")
                           : isGood
                               ? words("all_runs_good", words.number(double(all)))
                               : words("runs_good", words.number(good), words.number(double(all)));
  std::string out = element("p", escaped(text), "outcome") + "\n" + element("p", escaped(counts));
  if (!study.runs.empty())
    out.append("\n").append(
        element("p", escaped(words("look_first")).append(" ").append(linkToRun(study, 0))));
  return std::string("<div class=\"banner ") + (isGood ? "good" : "bad") + "\">" + out + "</div>\n";
}

std::string studyTable(const StudyReport& study, const Words& words) {
  Cells cells{{"run", "state", "worst_neighbour", "verdict", "distance", "guaranteed", "time",
               "depth", "page"}};
  for (std::string& head : cells[0]) head = escaped(words(head));
  for (std::size_t i = 0; i < study.runs.size(); ++i) {
    const Json& row = study.runs[i].row;
    const auto length = [&](const char* key) {
      return row.contains(key) ? escaped(words.millimetres(lengthOf(row, key))) : "";
    };
    const std::string page = pageOf(row);
    const std::string verdict = row.value("verdict", "");
    cells.push_back(
        {linkToRun(study, i), stateMark(row, words), escaped(row.value("neighbour", "")),
         verdict.empty() ? "" : verdictMark(verdict, row.at("state") == "done", words),
         length("distance"), length("guaranteed"),
         row.contains("time_seconds") ? escaped(words.seconds(row["time_seconds"].get<double>()))
                                      : "",
         length("depth"), page.empty() ? "" : linkTo(page, words("page_link"))});
  }
  return section("runs", words("runs"), tableOf(cells, "ttttnnnnt"));
}

std::string studyRuns(const StudyReport& study, const Words& words) {
  std::string out;
  for (std::size_t i = 0; i < study.runs.size(); ++i) {
    const StudyRun& run = study.runs[i];
    std::string content = headOf(run.row, words);
    if (run.clearance) {
      const CheckReport& check = *run.clearance;
      content += partOf("verdicts", verdictRows(check, words), words);
      content += partOf("graph", graphFigure(check, words), words);
      content += partOf("rules", rulesRows(check, words), words);
      content += partOf("findings", findingsItems(check, words), words);
    }
    out += section(anchorOf(i), run.row.at("run").get<std::string>(), content);
  }
  return out;
}

}  // namespace swept::page
