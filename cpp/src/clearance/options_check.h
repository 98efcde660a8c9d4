// Checks the numeric options of clearance checks.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

#include "swept/clearance.h"

namespace swept::clearance {

/// Throws Error(InvalidInput, "BadOption") unless the length (mm) is finite, at most 1e9 and
/// positive, or 0 if `mayBeZero`.
void requireLength(const std::string& name, double value, bool mayBeZero);

/// Throws Error(InvalidInput, "BadOption") if a setting is out of its range.
void checkSettings(const ClearanceOptions& options);

}  // namespace swept::clearance
