// SPDX-License-Identifier: LGPL-2.1-or-later
#include "clearance/row_json.h"
#include "swept/overlap.h"

namespace swept {
namespace {

Json pairJson(const OverlapReport& report, const PairOverlap& pair) {
  Json json{{"first", report.names[pair.parts.first]}, {"second", report.names[pair.parts.second]}};
  if (pair.volume) json["volume"] = *pair.volume;
  json["clearance"] = clearance::rowJson(pair.clearance);
  return json;
}

}  // namespace

std::string toJson(const OverlapReport& report) {
  Json json = reportHead("overlap", report.status, report.code, report.message);
  if (!report.summary.empty()) {  // a summary exists even if only the writing of an output failed
    json["summary"] = report.summary;
    json["parts"] = report.names;
    json["required"] = report.required;
    json["tolerance"] = report.tolerance;
    json["triangles"] = report.triangles;
    json["threads"] = report.threads;
  }
  if (report.smallest) json["smallest"] = *report.smallest;
  Json pairs = Json::array();
  for (const PairOverlap& pair : report.pairs) pairs.push_back(pairJson(report, pair));
  json["pairs"] = std::move(pairs);
  return finishedText(std::move(json), report);
}

}  // namespace swept
