// Options of all commands for path searches.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

#include "options.h"
#include "swept/path.h"

namespace swept::cli {

/// Converts "x,y,z" or "x,y,z,qx,qy,qz,qw" to a pose. `name`: the option, for messages.
Pose placementOf(const std::string& name, const std::string& text);
/// Converts a radius in mm, or a direction "x,y,z", which gives where the part comes from.
Extraction extractionOf(const std::string& name, const std::string& text);
/// Adds the options from --clearance to --interpolation. `seed` is separate, since it is unsigned
/// in PathOptions and addInteger() takes a signed number.
void addSearchOptions(CLI::App& app, PathOptions& options, std::int64_t& seed);
/// Returns the key poses in the format of a motion file.
std::string motionTable(const Trajectory& motion);

}  // namespace swept::cli
