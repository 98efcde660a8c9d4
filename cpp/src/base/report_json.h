// Reports as JSON, for those who add fields of their own to the same object.
// Keys stand in the order in which they were added; docs/report.schema.json describes them.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "swept/report.h"
#include "swept/types.h"

namespace swept {

using Json = nlohmann::ordered_json;

/// Raised when a key changes its meaning or goes; new keys do not raise it.
constexpr int kReportVersion = 1;

/// Version, command and how it ended: what every report begins with.
Json reportHead(const char* command, Status status, const std::string& code,
                const std::string& message);
/// What the checker found; nothing where no mesh was checked.
Json checkJson(const MeshCheck& check);
Json findingsJson(const std::vector<Finding>& findings);
Json secondsJson(const std::vector<StageSeconds>& seconds);
Json vectorJson(const Eigen::Vector3d& v);
Json poseJson(const Pose& pose);
/// The whole report of a run. Keys that do not apply are absent.
Json reportJson(const Report& report, const char* command = "envelope");

/// UTF-8, two blanks an indent; bytes that are no UTF-8 are replaced, numbers that are not finite
/// become null. The same text on every machine and in every locale.
std::string jsonText(const Json& json);

}  // namespace swept
