// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/json_writer.h"
#include "swept/clearance.h"

namespace swept {
namespace {

void put(JsonWriter& json, const char* name, const Eigen::Vector3d& v) {
  json.key(name).beginArray().value(v[0]).value(v[1]).value(v[2]).endArray();
}

void put(JsonWriter& json, const Pose& pose) {
  json.key("pose").beginObject().field("t", pose.timeSeconds);
  put(json, "translation", pose.translation);
  const Eigen::Quaterniond& q = pose.rotation;
  json.key("quaternion_xyzw").beginArray();
  json.value(q.x()).value(q.y()).value(q.z()).value(q.w()).endArray().endObject();
}

void put(JsonWriter& json, const char* name, const std::vector<TimeInterval>& intervals) {
  json.key(name).beginArray();
  for (const TimeInterval& i : intervals) json.beginArray().value(i.from).value(i.to).endArray();
  json.endArray();
}

void put(JsonWriter& json, const PenetrationResult& p) {
  json.key("penetration").beginObject();
  json.field("depth", p.depth).field("depth_bound", p.depthBound);
  json.field("time_seconds", p.timeSeconds);
  put(json, p.pose);
  json.field("point_of", p.pointOfBody ? "body" : "neighbour");
  put(json, "point", p.point);
  put(json, "surface", p.surface);
  put(json, "region_min", p.regionMin);
  put(json, "region_max", p.regionMax);
  json.endObject();
}

void put(JsonWriter& json, const NeighbourClearance& row) {
  json.beginObject().field("name", row.name).field("verdict", clearanceVerdictName(row.verdict));
  json.field("distance", row.distance).field("guaranteed", row.guaranteed);
  json.field("chord_error", row.chordError).field("time_seconds", row.timeSeconds);
  put(json, row.pose);
  put(json, "point_on_body", row.pointOnBody);
  put(json, "point_on_neighbour", row.pointOnNeighbour);
  json.field("body_triangle", row.bodyTriangle).field("neighbour_triangle", row.neighbourTriangle);
  json.field("closed", row.closed).field("inside", row.inside);
  if (row.penetration.known) put(json, row.penetration);
  put(json, "below", row.below);
  put(json, "contact", row.contact);
  json.key("curve").beginArray();
  for (const CurvePoint& p : row.curve)
    json.beginArray().value(p.timeSeconds).value(p.distance).endArray();
  json.endArray().field("distance_queries", row.distanceQueries);
  json.field("certificates", row.certificates).field("seconds", row.seconds).endObject();
}

}  // namespace

std::string toJson(const ClearanceReport& report) {
  JsonWriter json;
  json.beginObject().field("status", statusName(report.status)).field("code", report.code);
  json.field("message", report.message).field("summary", report.summary);
  json.field("required", report.required).field("tolerance", report.tolerance);
  json.field("interpolation", report.interpolation).field("witness", report.witness);
  json.field("placements", report.placements).field("body_triangles", report.bodyTriangles);
  json.field("neighbour_triangles", report.neighbourTriangles).field("threads", report.threads);
  json.field("smallest", report.smallest).key("neighbours").beginArray();
  for (const NeighbourClearance& row : report.neighbours) put(json, row);
  json.endArray().key("seconds").beginObject();
  for (const StageSeconds& stage : report.seconds) json.field(stage.stage, stage.seconds);
  json.endObject().key("warnings").beginArray();
  for (const Finding& finding : report.warnings) {
    json.beginObject().field("code", finding.code).field("count", finding.count);
    json.key("first").beginArray();
    for (const std::int64_t i : finding.first) json.value(i);
    json.endArray().field("text", finding.text).endObject();
  }
  json.endArray().endObject();
  return json.text();
}

}  // namespace swept
