// What a search is asked for, refused before anything is computed where it makes no sense.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

#include "swept/path.h"

namespace swept::path {

/// Throws Error(InvalidInput) BadOption, NoNeighbours, NoStart with what, how much and what is
/// allowed.
void checkPathOptions(const PathTask& task, const std::vector<ClearanceNeighbour>& neighbours,
                      const PathOptions& options);

/// Normalised. `what`: "goal", "start", ... Throws Error(InvalidInput) BadPose, OutOfRange.
Pose checkedPose(const Pose& pose, const std::string& what);

}  // namespace swept::path
