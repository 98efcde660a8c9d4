// SPDX-License-Identifier: LGPL-2.1-or-later
#include "page/sections.h"

#include "base/number_text.h"
#include "page/html.h"

namespace swept::page {
namespace {

using Cells = std::vector<std::vector<std::string>>;

std::string ruleOf(const Row& row, const Words& words) {
  if (row.contact)
    return *row.contact > 0 ? words("rule_depth", words.millimetres(*row.contact))
                            : words("rule_contact");
  if (row.required.value_or(0) > 0) return words("rule_required", words.millimetres(*row.required));
  return words("rule_none");
}

std::string depthOf(const Row& row, const Words& words) {
  if (row.depth)
    return words("depth_range", words.number(row.depth->least), words.millimetres(row.depth->most));
  return row.verdict == "clash" ? words("depth_unknown") : "";
}

}  // namespace

std::string verdictMark(const std::string& verdict, bool allowed, const Words& words) {
  const std::string kind = allowed && verdict == "contact" ? "allowed" : verdict;
  return element("span", escaped(words(kind)), "verdict " + kind);
}

std::string verdictBanner(const CheckReport& check, const Words& words) {
  const std::size_t bad = check.failing(), all = check.rows.size();
  const std::string count = words.number(double(bad)), of = words.number(double(all));
  std::string text;
  if (all == 0)
    text = words(check.mechanism ? "none_near" : "nothing_checked");
  else if (bad == 0)
    text = all == 1 ? words("one_met") : words("all_met", of);
  else
    text = words(bad == 1 ? "one_not_met" : "not_met", count, of);
  std::string out = element("p", escaped(text), "outcome");
  if (all > 0) {
    const Row& worst = check.rows[check.order[0]];
    const bool deep = worst.depth && worst.verdict == "clash";
    const std::string extreme =
        deep ? words("deepest", words.number(worst.depth->least) + " mm",
                     words.seconds(worst.depth->time))
             : words("nearest", words.millimetres(worst.distance), words.seconds(worst.time));
    out.append("\n").append(element("p", escaped(extreme + " (" + worst.name + ")")));
  }
  return std::string("<div class=\"banner ") + (bad ? "bad" : "good") + "\">" + out + "</div>\n";
}

std::string verdictRows(const CheckReport& check, const Words& words) {
  Cells cells{{words(check.mechanism ? "pair" : "neighbour"), words("verdict"), words("distance"),
               words("guaranteed"), words("time"), words("depth"), words("below_for")}};
  for (std::string& head : cells[0]) head = escaped(head);
  std::vector<std::string> rows;
  for (const std::size_t index : check.order) {
    const Row& row = check.rows[index];
    cells.push_back({escaped(row.name), verdictMark(row.verdict, row.meetsRule, words),
                     escaped(words.millimetres(row.distance)),
                     escaped(words.millimetres(row.guaranteed)), escaped(words.seconds(row.time)),
                     escaped(depthOf(row, words)),
                     row.belowSeconds > 0 ? escaped(words.seconds(row.belowSeconds)) : ""});
    rows.push_back(textOf(kTellingDigits, " data-row=\"", index, "\""));
  }
  for (const std::string& name : check.ignored) {
    const std::string mark = element("span", escaped(words("ignored")), "verdict ignored");
    cells.push_back({escaped(name), mark, "", "", "", "", ""});
  }
  const bool copies = check.report.value("interpolation", "") == "none";
  const std::string promise = escaped(words(copies ? "promise_copies" : "promise"));
  return table(cells, "ttnnnnn", rows) + element("p", promise, "note");
}

std::string verdictTable(const CheckReport& check, const Words& words) {
  return section("verdicts", words("verdicts"), verdictRows(check, words));
}

std::string rulesRows(const CheckReport& check, const Words& words) {
  Cells cells{{escaped(words(check.mechanism ? "pair" : "neighbour")), escaped(words("rule")),
               escaped(words("met"))}};
  for (const std::size_t index : check.order) {
    const Row& row = check.rows[index];
    cells.push_back({escaped(row.name), escaped(ruleOf(row, words)),
                     escaped(words(row.meetsRule ? "yes" : "no"))});
  }
  for (const std::string& name : check.ignored)
    cells.push_back({escaped(name), escaped(words("rule_ignore")), ""});
  for (const std::string& name : check.joined)
    cells.push_back({escaped(name), escaped(words("joined")), ""});
  return cells.size() == 1 ? std::string() : table(cells, "ttt");
}

std::string rulesTable(const CheckReport& check, const Words& words) {
  return section("rules", words("rules"), rulesRows(check, words));
}

std::string settingsTable(const CheckReport& check, const Words& words) {
  Cells cells{{escaped(words("setting")), escaped(words("value"))}};
  const Json& report = check.report;
  const auto add = [&](const std::string& key, const std::string& value) {
    cells.push_back({escaped(words(key)), escaped(value)});
  };
  for (const char* key : {"required", "tolerance", "range"})
    if (report.contains(key)) add(key, words.millimetres(report[key].get<double>()));
  if (report.contains("interpolation")) {
    const std::string kind = report["interpolation"].get<std::string>();
    add("interpolation", words.has(kind) ? words(kind) : kind);
  }
  if (report.contains("from_seconds") && report.contains("to_seconds"))
    add("span", words("span_text", words.number(report["from_seconds"].get<double>()),
                      words.seconds(report["to_seconds"].get<double>())));
  if (report.contains("witness"))
    add("witness", words(report["witness"] == "envelope" ? "witness_envelope" : "witness_motion"));
  for (const char* key :
       {"placements", "body_triangles", "neighbour_triangles", "triangles", "far_pairs"})
    if (report.contains(key)) add(key, std::to_string(report[key].get<std::int64_t>()));
  return section("settings", words("settings"), table(cells, "tt"));
}

std::string inputsTable(const std::vector<PageInput>& inputs, const Words& words) {
  if (inputs.empty()) return {};
  Cells cells{{words("role"), words("name"), words("detail"), words("sha256")}};
  for (std::string& head : cells[0]) head = escaped(head);
  for (const PageInput& input : inputs) {
    const std::string key = "role_" + input.role;
    const std::string hash = input.sha256.empty() ? escaped(words("hash_unknown"))
                                                  : element("code", escaped(input.sha256), "hash");
    cells.push_back({escaped(words.has(key) ? words(key) : input.role), escaped(input.name),
                     escaped(input.detail), hash});
  }
  return section("inputs", words("inputs"), table(cells, "tttt"));
}

std::string findingsItems(const CheckReport& check, const Words& words) {
  std::string items;
  for (const Json& finding : check.report.value("warnings", Json::array()))
    items += element("li", element("code", escaped(finding.value("code", ""))) + " " +
                               escaped(finding.value("text", ""))) +
             "\n";
  if (items.empty()) return {};
  std::string out = element("ul", "\n" + items);
  if (words.language() != check.report.value("findings_language", "en"))
    out += element("p", escaped(words("findings_language")), "note");
  return out;
}

std::string findingsList(const CheckReport& check, const Words& words) {
  const std::string items = findingsItems(check, words);
  return section("findings", words("findings"),
                 items.empty() ? element("p", escaped(words("no_findings"))) : items);
}

std::string picturesOf(const std::vector<PagePicture>& pictures, const Words& words) {
  std::string out;
  for (const PagePicture& picture : pictures) {
    if (picture.mediaType != "image/png" && picture.mediaType != "image/jpeg" &&
        picture.mediaType != "image/svg+xml")
      throw Error(Status::InvalidInput, "BadOption",
                  "the type of a picture is '" + picture.mediaType +
                      "'; allowed: image/png, image/jpeg, image/svg+xml");
    const std::string caption = escaped(picture.caption);
    out += element("figure", "<img alt=\"" + caption + "\" src=\"data:" + picture.mediaType +
                                 ";base64," + base64(picture.bytes.data(), picture.bytes.size()) +
                                 "\" />" + element("figcaption", caption)) +
           "\n";
  }
  return section("pictures", words("pictures"), out);
}

}  // namespace swept::page
