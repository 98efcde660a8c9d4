// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>

#include "path/path_json.h"
#include "swept/sequence.h"

namespace swept {
namespace {

Json stepJson(const SequenceReport& report, const SequenceStep& step) {
  Json json{{"part", report.names[step.part]}};
  if (report.verdict == SequenceVerdict::Found) {
    json["begin"] = step.begin;
    json["end"] = step.end;
  }
  path::addAnswer(json, step.path);
  return json;
}

Json ignoredJson(const SequenceReport& report) {
  const auto nameOf = [&](std::int32_t i) {
    const auto k = static_cast<std::size_t>(i);
    return k < report.names.size() ? report.names[k] : report.still[k - report.names.size()];
  };
  Json list = Json::array();
  for (const PartPair& pair : report.ignored)
    list.push_back({nameOf(pair.first), nameOf(pair.second)});
  return list;
}

}  // namespace

std::string toJson(const SequenceReport& report) {
  Json json = reportHead("sequence", report.status, report.code, report.message);
  if (report.status != Status::Ok) return jsonText(json);
  json["verdict"] = sequenceVerdictName(report.verdict);
  json["summary"] = report.summary;
  json["order"] = report.orderFound ? "find" : "given";
  json["parts"] = report.names;
  json["still"] = report.still;
  json["required"] = report.required;
  json["tolerance"] = report.tolerance;
  json["release"] = report.release;
  json["interpolation"] = report.interpolation;
  json["seed"] = report.seed;
  if (report.verdict == SequenceVerdict::Found) {
    json["duration"] = report.duration;
    if (std::isfinite(report.clearance)) json["clearance"] = report.clearance;
  }
  json["steps"] = Json::array();
  for (const SequenceStep& step : report.steps) json["steps"].push_back(stepJson(report, step));
  if (!report.ignored.empty()) json["ignored"] = ignoredJson(report);
  json["budget_ended"] = report.budgetEnded;
  json["searches"] = report.searches;
  json["moves"] = report.moves;
  json["triangles"] = report.triangles;
  json["threads"] = report.threads;
  return finishedText(std::move(json), report);
}

}  // namespace swept
