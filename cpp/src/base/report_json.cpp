// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/report_json.h"

#include "swept/accuracy.h"
#include "swept/check_text.h"

namespace swept {

Json reportHead(const char* command, Status status, const std::string& code,
                const std::string& message) {
  return {{"report_version", kReportVersion},
          {"command", command},
          {"status", statusName(status)},
          {"code", code},
          {"message", message}};
}

Json checkJson(const MeshCheck& check) {
  if (check.vertices == 0 && check.triangles == 0) return Json::object();
  Json json{{"vertices", check.vertices},
            {"triangles", check.triangles},
            {"shells", check.shells},
            {"finite", check.finite},
            {"closed", check.closed},
            {"manifold", check.manifold},
            {"oriented", check.oriented},
            {"open_edges", check.openEdges},
            {"non_manifold_edges", check.nonManifoldEdges},
            {"non_manifold_vertices", check.nonManifoldVertices},
            {"misoriented_edges", check.misorientedEdges},
            {"degenerate_triangles", check.degenerateTriangles},
            {"unused_vertices", check.unusedVertices}};
  if (check.selfIntersections) {
    json["self_intersections"] = *check.selfIntersections;
    json["first_intersections"] = check.firstIntersections;
  }
  json["volume"] = check.volume;
  json["area"] = check.area;
  return json;
}

Json findingsJson(const std::vector<Finding>& findings) {
  Json list = Json::array();
  for (const Finding& finding : findings) {
    list.push_back({{"code", finding.code},
                    {"count", finding.count},
                    {"first", finding.first},
                    {"text", finding.text}});
  }
  return list;
}

Json vectorJson(const Eigen::Vector3d& v) { return {v[0], v[1], v[2]}; }

Json poseJson(const Pose& pose) {
  const Eigen::Quaterniond& q = pose.rotation;
  return {{"t", pose.timeSeconds},
          {"translation", vectorJson(pose.translation)},
          {"quaternion_xyzw", {q.x(), q.y(), q.z(), q.w()}}};
}

Json secondsJson(const std::vector<StageSeconds>& seconds) {
  Json json = Json::object();
  for (const StageSeconds& stage : seconds) json[stage.stage] = stage.seconds;
  return json;
}

Json reportJson(const Report& report, const char* command) {
  Json json = reportHead(command, report.status, report.code, report.message);
  json.update(checkJson(report.check));
  if (report.cellSize > 0) {
    const Eigen::Vector3d& origin = report.gridOrigin;
    json["cell"] = report.cellSize;
    json["grid"] = report.grid;
    json["grid_origin"] = {origin[0], origin[1], origin[2]};
  }
  if (report.placements > 0) {
    json["placements"] = report.placements;
    json["refined_placements"] = report.refinedPlacements;
    json["largest_step_travel"] = report.largestStepTravel;
    json["chord_error"] = report.chordError;
    if (report.bodyDeviation > 0) json["body_deviation"] = report.bodyDeviation;
  }
  if (report.crossings > 0) {
    json["swept_faces"] = report.sweptFaces;
    json["swept_patches"] = report.sweptPatches;
    json["crossings"] = report.crossings;
  }
  if (report.positionFilterDistance > 0)
    json["position_filter_distance"] = report.positionFilterDistance;
  if (report.crossings > 0) json["simplification_deviation"] = report.simplificationDeviation;
  if (const std::optional<double> bound = accuracyBound(report)) json["accuracy_bound"] = *bound;
  if (report.conservativeBound) json["conservative_bound"] = *report.conservativeBound;
  if (report.threads > 0) {
    json["backend"] = report.backend;
    json["device"] = report.device;
    json["threads"] = report.threads;
  }
  json["seconds"] = secondsJson(report.seconds);
  if (report.peakMemoryBytes > 0) {
    json["estimated_memory_bytes"] = report.estimatedMemoryBytes;
    json["peak_memory_bytes"] = report.peakMemoryBytes;
  }
  json["warnings"] = findingsJson(report.warnings);
  return json;
}

std::string jsonText(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string toJson(const MeshCheck& check) {
  Json json{{"passes", check.passes()}};
  json.update(checkJson(check));
  return jsonText(json);
}

std::string toJson(const Report& report) { return jsonText(reportJson(report)); }

}  // namespace swept
