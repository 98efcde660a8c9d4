// Checks the input of a search before anything is computed.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

#include "swept/path.h"

namespace swept::path {

/// Throws Error(InvalidInput) with BadOption, NoNeighbours or NoStart. The text gives the value and
/// what is allowed.
void checkPathOptions(const PathTask& task, const std::vector<ClearanceNeighbour>& neighbours,
                      const PathOptions& options);

/// Returns the name of a key in messages, which count from 1. `index`: counts from 0.
std::string keyName(std::size_t index);

/// Returns the pose with a unit quaternion. `what`: "the goal", "key 2" and so on, for messages.
/// Throws Error(InvalidInput) with BadPose or OutOfRange.
Pose checkedPose(const Pose& pose, const std::string& what);

}  // namespace swept::path
