// What the commands that search for paths share: placements, how far out, options of a search.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

#include "options.h"
#include "swept/path.h"

namespace swept::cli {

/// "x,y,z" or "x,y,z,qx,qy,qz,qw"; `name`: the option, for messages.
Pose placementOf(const std::string& name, const std::string& text);
/// A radius in mm or a direction "x,y,z".
Extraction extractionOf(const std::string& name, const std::string& text);
/// --clearance to --interpolation; the seed is kept apart since options are signed.
void addSearchOptions(CLI::App& app, PathOptions& options, std::int64_t& seed);
/// The keys as a motion file.
std::string motionTable(const Trajectory& motion);

}  // namespace swept::cli
