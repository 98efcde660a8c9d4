// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/report_json.h"

#include "swept/check_text.h"

namespace swept {
namespace {

void writeFinding(const Finding& finding, JsonWriter& json) {
  json.beginObject();
  json.field("code", finding.code);
  json.field("count", finding.count);
  json.key("first").beginArray();
  for (const std::int64_t index : finding.first) json.value(index);
  json.endArray();
  json.field("text", finding.text);
  json.endObject();
}

}  // namespace

void writeCheckFields(const MeshCheck& check, JsonWriter& json) {
  json.field("vertices", check.vertices);
  json.field("triangles", check.triangles);
  json.field("shells", check.shells);
  json.field("finite", check.finite);
  json.field("closed", check.closed);
  json.field("manifold", check.manifold);
  json.field("oriented", check.oriented);
  json.field("open_edges", check.openEdges);
  json.field("non_manifold_edges", check.nonManifoldEdges);
  json.field("non_manifold_vertices", check.nonManifoldVertices);
  json.field("misoriented_edges", check.misorientedEdges);
  json.field("degenerate_triangles", check.degenerateTriangles);
  json.field("unused_vertices", check.unusedVertices);
  json.field("self_intersections", check.selfIntersections);
  json.key("first_intersections").beginArray();
  for (const auto& [a, b] : check.firstIntersections) {
    json.beginArray().value(a).value(b).endArray();
  }
  json.endArray();
  json.field("volume", check.volume);
  json.field("area", check.area);
}

void writeReportFields(const Report& report, JsonWriter& json) {
  json.field("status", statusName(report.status));
  json.field("code", report.code);
  json.field("message", report.message);
  writeCheckFields(report.check, json);
  json.field("cell", report.cellSize);
  json.key("grid").beginArray();
  for (const std::int64_t n : report.grid) json.value(n);
  json.endArray();
  json.key("grid_origin").beginArray();
  for (int axis = 0; axis < 3; ++axis) json.value(report.gridOrigin[axis]);
  json.endArray();
  json.field("placements", report.placements);
  json.field("refined_placements", report.refinedPlacements);
  json.field("position_filter_distance", report.positionFilterDistance);
  json.field("swept_faces", report.sweptFaces);
  json.field("swept_patches", report.sweptPatches);
  json.field("crossings", report.crossings);
  json.field("largest_step_travel", report.largestStepTravel);
  json.field("chord_error", report.chordError);
  json.field("simplification_deviation", report.simplificationDeviation);
  json.field("conservative_bound", report.conservativeBound);
  json.field("backend", report.backend);
  json.field("device", report.device);
  json.field("threads", report.threads);
  json.key("seconds").beginObject();
  for (const StageSeconds& stage : report.seconds) json.field(stage.stage, stage.seconds);
  json.endObject();
  json.field("estimated_memory_bytes", report.estimatedMemoryBytes);
  json.field("peak_memory_bytes", report.peakMemoryBytes);
  json.key("warnings").beginArray();
  for (const Finding& finding : report.warnings) writeFinding(finding, json);
  json.endArray();
}

std::string toJson(const Report& report) {
  JsonWriter json;
  json.beginObject();
  writeReportFields(report, json);
  json.endObject();
  return json.text() + "\n";
}

std::string toJson(const MeshCheck& check) {
  JsonWriter json;
  json.beginObject();
  json.field("passes", check.passes());
  writeCheckFields(check, json);
  json.endObject();
  return json.text() + "\n";
}

}  // namespace swept
