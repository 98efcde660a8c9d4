// Reports as JSON objects, to which callers may add fields of their own. Keys appear in the order
// in which they are added. docs/report.schema.json describes them.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "swept/report.h"
#include "swept/types.h"

namespace swept {

using Json = nlohmann::ordered_json;

/// Version of the report format. It rises when a key changes its meaning or disappears, but not
/// when a key is added.
constexpr int kReportVersion = 1;

/// Returns the beginning of every report: version, command, status, code and message.
Json reportHead(const char* command, Status status, const std::string& code,
                const std::string& message);
/// Returns the findings of the mesh checker; empty if no mesh was checked.
Json checkJson(const MeshCheck& check);
Json findingsJson(const std::vector<Finding>& findings);
Json secondsJson(const std::vector<StageSeconds>& seconds);
Json vectorJson(const Eigen::Vector3d& v);
Json poseJson(const Pose& pose);
/// Returns the whole report of a run. Keys that do not apply are absent.
Json reportJson(const Report& report, const char* command = "envelope");

/// Returns the text in UTF-8, with two blanks per level. Replaces invalid UTF-8 bytes, and writes
/// null for numbers that are not finite. The text is the same on every machine and in every locale.
std::string jsonText(const Json& json);

/// Adds what ends the reports of most commands, and returns the text.
template <class AnyReport>
std::string finishedText(Json json, const AnyReport& report) {
  json["seconds"] = secondsJson(report.seconds);
  json["warnings"] = findingsJson(report.warnings);
  return jsonText(json);
}

}  // namespace swept
