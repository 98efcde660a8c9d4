// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/report_json.h"
#include "clearance/row_json.h"
#include "swept/clearance.h"

namespace swept {
namespace {

Json spansJson(const std::vector<TimeInterval>& spans) {
  Json list = Json::array();
  for (const TimeInterval& span : spans) list.push_back({span.from, span.to});
  return list;
}

Json penetrationJson(const PenetrationResult& p) {
  return {{"depth", p.depth},
          {"depth_bound", p.depthBound},
          {"time_seconds", p.timeSeconds},
          {"pose", poseJson(p.pose)},
          {"point_of", p.pointOfBody ? "body" : "neighbour"},
          {"point", vectorJson(p.point)},
          {"surface", vectorJson(p.surface)},
          {"region_min", vectorJson(p.regionMin)},
          {"region_max", vectorJson(p.regionMax)}};
}

Json ruleJson(const NeighbourRule& rule) {
  if (rule.contact) return {{"contact", *rule.contact}};
  return {{"required", rule.required.value_or(0)}};
}

}  // namespace

Json clearance::rowJson(const NeighbourClearance& row) {
  Json json{{"name", row.name},
            {"rule", ruleJson(row.rule)},
            {"verdict", clearanceVerdictName(row.verdict)},
            {"meets_rule", row.meetsRule()},
            {"distance", row.distance},
            {"guaranteed", row.guaranteed},
            {"chord_error", row.chordError},
            {"time_seconds", row.timeSeconds},
            {"pose", poseJson(row.pose)},
            {"point_on_body", vectorJson(row.pointOnBody)},
            {"point_on_neighbour", vectorJson(row.pointOnNeighbour)},
            {"body_triangle", row.bodyTriangle.value_or(-1)},
            {"neighbour_triangle", row.neighbourTriangle.value_or(-1)},
            {"closed", row.closed},
            {"inside", row.inside}};
  if (row.penetration.known) json["penetration"] = penetrationJson(row.penetration);
  json["below"] = spansJson(row.below);
  json["contact"] = spansJson(row.contact);
  Json curve = Json::array();
  for (const CurvePoint& p : row.curve) curve.push_back({p.timeSeconds, p.distance});
  json["curve"] = std::move(curve);
  json["distance_queries"] = row.distanceQueries;
  json["certificates"] = row.certificates;
  json["seconds"] = row.seconds;
  return json;
}

std::string toJson(const ClearanceReport& report) {
  Json json = reportHead("clearance", report.status, report.code, report.message);
  Json rows = Json::array();
  for (const NeighbourClearance& row : report.neighbours) rows.push_back(clearance::rowJson(row));
  if (report.placements > 0) {
    json["summary"] = report.summary;
    json["required"] = report.required;
    json["tolerance"] = report.tolerance;
    json["interpolation"] = report.interpolation;
    json["witness"] = report.witness;
    json["placements"] = report.placements;
    json["body_triangles"] = report.bodyTriangles;
    json["neighbour_triangles"] = report.neighbourTriangles;
    json["threads"] = report.threads;
  }
  if (report.smallest) json["smallest"] = *report.smallest;
  if (!report.ignored.empty()) json["ignored"] = report.ignored;
  json["neighbours"] = std::move(rows);
  return finishedText(std::move(json), report);
}

}  // namespace swept
