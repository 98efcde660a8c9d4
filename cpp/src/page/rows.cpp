// SPDX-License-Identifier: LGPL-2.1-or-later
#include "page/rows.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <string_view>

namespace swept::page {
namespace {

double numberOf(const Json& value, const char* what) {
  if (!value.is_number())
    badReport(std::string(what) + " is not a number; create the report again");
  return value.get<double>();
}

Eigen::Vector3d vectorOf(const Json& value, const char* what) {
  if (!value.is_array() || value.size() != 3)
    badReport(std::string(what) +
              " is not a point with three coordinates; create the report again");
  return {numberOf(value[0], what), numberOf(value[1], what), numberOf(value[2], what)};
}

Pose poseOf(const Json& value) {
  Pose pose;
  const Json& q = value.at("quaternion_xyzw");
  if (!q.is_array() || q.size() != 4)
    badReport("a quaternion does not have four numbers; create the report again");
  pose.rotation = Eigen::Quaterniond(numberOf(q[3], "quaternion"), numberOf(q[0], "quaternion"),
                                     numberOf(q[1], "quaternion"), numberOf(q[2], "quaternion"));
  pose.translation = vectorOf(value.at("translation"), "a translation");
  return pose;
}

void readDepth(const Json& json, Row& row) {
  if (!json.contains("penetration")) return;
  const Json& depth = json["penetration"];
  row.depth = {
      lengthOf(depth, "depth"), lengthOf(depth, "depth_bound"),
      depth.contains("time_seconds") ? numberOf(depth["time_seconds"], "time_seconds") : row.time};
  if (depth.contains("point") && depth.contains("surface"))
    row.line = {vectorOf(depth["point"], "point"), vectorOf(depth["surface"], "surface")};
}

void readRule(const Json& json, double common, Row& row) {
  row.required = common;
  if (!json.contains("rule")) return;
  const Json& rule = json["rule"];
  if (rule.contains("required")) row.required = lengthOf(rule, "required");
  if (!rule.contains("contact")) return;
  row.contact = lengthOf(rule, "contact");
  row.required.reset();
}

Row rowOf(const Json& json, double common) {
  Row row;
  row.name = row.second = json.at("name").get<std::string>();
  row.verdict = json.at("verdict").get<std::string>();
  if (!std::set<std::string_view>{"clear", "below", "contact", "clash"}.contains(row.verdict))
    badReport("the verdict '" + row.verdict + "' is unknown; create the report again");
  readRule(json, common, row);
  row.meetsRule =
      json.value("meets_rule", row.verdict == "clear" || (row.verdict == "contact" && row.contact));
  row.distance = lengthOf(json, "distance");
  row.guaranteed = lengthOf(json, "guaranteed");
  row.time = numberOf(json.at("time_seconds"), "time_seconds");
  row.line = {vectorOf(json.at("point_on_body"), "point_on_body"),
              vectorOf(json.at("point_on_neighbour"), "point_on_neighbour")};
  row.pose = poseOf(json.at("pose"));
  readDepth(json, row);
  for (const Json& span : json.value("below", Json::array()))
    row.belowSeconds += numberOf(span.at(1), "below") - numberOf(span.at(0), "below");
  for (const Json& point : json.value("curve", Json::array()))
    row.curve.emplace_back(numberOf(point.at(0), "curve"), numberOf(point.at(1), "curve"));
  return row;
}

std::vector<std::string> namesOf(const Json& report, const char* key) {
  std::vector<std::string> names;
  for (const Json& item : report.value(key, Json::array()))
    names.push_back(item.is_array()
                        ? item.at(0).get<std::string>() + " - " + item.at(1).get<std::string>()
                        : item.get<std::string>());
  return names;
}

// Removes measurements of time and memory, which differ from run to run.
void dropMeasures(Json& report) {
  for (const char* key : {"seconds", "threads", "estimated_memory_bytes", "peak_memory_bytes"})
    report.erase(key);
  for (const char* list : {"neighbours", "pairs"}) {
    if (!report.contains(list)) continue;
    for (Json& row : report[list])
      (row.contains("clearance") ? row["clearance"] : row).erase("seconds");
  }
}

int rankOf(const Row& row) {
  if (row.meetsRule) return 3;
  return row.verdict == "clash" ? 0 : row.verdict == "contact" ? 1 : 2;
}

void readRows(CheckReport& check) {
  const Json& report = check.report;
  const double common = report.contains("required") ? lengthOf(report, "required") : 0.0;
  if (!check.mechanism) {
    for (const Json& json : report.at("neighbours")) check.rows.push_back(rowOf(json, common));
    return;
  }
  for (const Json& pair : report.at("pairs")) {
    Row row = rowOf(pair.at("clearance"), common);
    row.first = pair.at("first").get<std::string>();
    row.second = pair.at("second").get<std::string>();
    row.required = lengthOf(pair, "required");
    check.rows.push_back(std::move(row));
  }
}

}  // namespace

std::size_t CheckReport::failing() const {
  return static_cast<std::size_t>(
      std::count_if(rows.begin(), rows.end(), [](const Row& row) { return !row.meetsRule; }));
}

void badReport(const std::string& text) {
  throw Error(Status::InvalidInput, "BadReport",
              "this report cannot be turned into an HTML page: " + text);
}

double lengthOf(const Json& row, const char* key) {
  const double value = numberOf(row.at(key), key);
  if (!(value >= 0 && std::isfinite(value)))
    badReport(std::string(key) + " is not a length of 0 or more; create the report again");
  return value;
}

Json parseReport(const std::string& text) {
  Json report = Json::parse(text);
  if (!report.is_object() || report.value("report_version", 0) != kReportVersion)
    badReport("it is not a report of version " + std::to_string(kReportVersion) +
              "; create the report again");
  const std::string command = report.value("command", "");
  if (command != "clearance" && command != "mechanism" && command != "study")
    badReport("its command is '" + command +
              "'; pages are made for 'clearance', 'mechanism' and 'study'");
  // A page of a study also shows its failed runs.
  if (command != "study" && report.value("status", "") != "Ok")
    badReport("its run ended with " + report.value("status", "?") + ": " +
              report.value("message", ""));
  return report;
}

CheckReport readCheck(Json report) {
  CheckReport check;
  check.report = std::move(report);
  check.mechanism = check.report.value("command", "") == "mechanism";
  dropMeasures(check.report);
  readRows(check);
  check.ignored = namesOf(check.report, "ignored");
  check.joined = namesOf(check.report, "joined");
  check.order.resize(check.rows.size());
  std::iota(check.order.begin(), check.order.end(), std::size_t{0});
  std::stable_sort(check.order.begin(), check.order.end(), [&](std::size_t a, std::size_t b) {
    const Row &x = check.rows[a], &y = check.rows[b];
    if (rankOf(x) != rankOf(y)) return rankOf(x) < rankOf(y);
    const double deepX = x.depth ? x.depth->least : 0, deepY = y.depth ? y.depth->least : 0;
    if (rankOf(x) == 0 && deepX != deepY) return deepX > deepY;
    return x.distance < y.distance;
  });
  return check;
}

}  // namespace swept::page
