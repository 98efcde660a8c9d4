// Options that the commands for paths share: placements, extraction, and settings of a search.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

#include "options.h"
#include "swept/path.h"

namespace swept::cli {

/// Parses "x,y,z" or "x,y,z,qx,qy,qz,qw". `name`: the option, for messages.
Pose placementOf(const std::string& name, const std::string& text);
/// Parses a radius in mm or a direction "x,y,z". `name`: the option, for messages.
Extraction extractionOf(const std::string& name, const std::string& text);
/// Adds the options from --clearance to --interpolation. The seed has its own argument because
/// numbers of options are signed.
void addSearchOptions(CLI::App& app, PathOptions& options, std::int64_t& seed);
/// Returns the keys as the text of a motion file.
std::string motionTable(const Trajectory& motion);

}  // namespace swept::cli
