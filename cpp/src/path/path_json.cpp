// SPDX-License-Identifier: LGPL-2.1-or-later
#include "path/path_json.h"

#include <cmath>
#include <numbers>

namespace swept {
namespace path {

void addAnswer(Json& json, const PathReport& report) {
  json["verdict"] = pathVerdictName(report.verdict);
  json["summary"] = report.summary;
  if (report.verdict == PathVerdict::Found) {
    json["method"] = report.method;
    json["keys"] = report.path.poses.size();
    json["length"] = report.length;
    json["turn_degrees"] = report.turn * 180 / std::numbers::pi;
    // Without neighbours the clearance is infinite, which JSON cannot express.
    if (std::isfinite(report.clearance)) json["clearance"] = report.clearance;
    json["contacts"] = report.contacts;
    json["path"] = Json::array();
    for (const Pose& pose : report.path.poses) json["path"].push_back(poseJson(pose));
    json["certificate"] = Json::array();
    for (const NeighbourClearance& row : report.certificate)
      json["certificate"].push_back({{"name", row.name},
                                     {"verdict", clearanceVerdictName(row.verdict)},
                                     {"distance", row.distance},
                                     {"guaranteed", row.guaranteed},
                                     {"time_seconds", row.timeSeconds}});
  } else {
    json["escape"] = {{"distance", report.escape.distance},
                      {"pose", poseJson(report.escape.pose)},
                      {"blockers", report.escape.blockers}};
    if (report.possibleClearance) json["possible_clearance"] = *report.possibleClearance;
    json["budget_ended"] = report.budgetEnded;
  }
  if (report.before) {
    json["kept_moves"] = report.keptMoves;
    json["unmended_moves"] = report.unmendedMoves;
    json["before"] = {{"keys", report.before->keys},
                      {"length", report.before->length},
                      {"turn_degrees", report.before->turn * 180 / std::numbers::pi},
                      {"clearance", report.before->clearance}};
  }
}

}  // namespace path

std::string toJson(const PathReport& report) {
  Json json = reportHead("path", report.status, report.code, report.message);
  if (report.status != Status::Ok) return jsonText(json);
  path::addAnswer(json, report);
  json["required"] = report.required;
  json["tolerance"] = report.tolerance;
  json["release"] = report.release;
  json["interpolation"] = report.interpolation;
  json["seed"] = report.seed;
  if (!report.ignored.empty()) json["ignored"] = report.ignored;
  json["steps"] = report.steps;
  json["body_triangles"] = report.bodyTriangles;
  json["neighbour_triangles"] = report.neighbourTriangles;
  json["threads"] = report.threads;
  return finishedText(std::move(json), report);
}

}  // namespace swept
