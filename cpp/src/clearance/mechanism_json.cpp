// SPDX-License-Identifier: LGPL-2.1-or-later
#include "clearance/row_json.h"
#include "swept/mechanism.h"

namespace swept {
namespace {

Json namesJson(const MechanismReport& report, const PartPair& pair) {
  return {report.names[pair.first], report.names[pair.second]};
}

Json listJson(const MechanismReport& report, const std::vector<PartPair>& pairs) {
  Json list = Json::array();
  for (const PartPair& pair : pairs) list.push_back(namesJson(report, pair));
  return list;
}

Json pairJson(const MechanismReport& report, const PairClearance& pair) {
  return {{"first", report.names[pair.parts.first]},
          {"second", report.names[pair.parts.second]},
          {"required", pair.required},
          {"pose_of_second", poseJson(pair.poseOfSecond)},
          {"clearance", clearance::rowJson(pair.clearance)}};
}

}  // namespace

std::string toJson(const MechanismReport& report) {
  Json json = reportHead("mechanism", report.status, report.code, report.message);
  // A report also has a summary if only the writing of an output failed.
  if (!report.summary.empty()) {
    json["summary"] = report.summary;
    json["parts"] = report.names;
    json["required"] = report.required;
    json["tolerance"] = report.tolerance;
    json["range"] = report.range;
    json["from_seconds"] = report.time.from;
    json["to_seconds"] = report.time.to;
    json["triangles"] = report.triangles;
    json["threads"] = report.threads;
    json["far_pairs"] = report.farPairs;
    json["ignored"] = listJson(report, report.ignored);
    json["joined"] = listJson(report, report.joined);
  }
  if (report.smallest) json["smallest"] = *report.smallest;
  Json pairs = Json::array();
  for (const PairClearance& pair : report.pairs) pairs.push_back(pairJson(report, pair));
  json["pairs"] = std::move(pairs);
  return finishedText(std::move(json), report);
}

}  // namespace swept
