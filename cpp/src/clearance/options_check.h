// What clearance checks ask of the numbers that they are given.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

#include "swept/clearance.h"

namespace swept::clearance {

/// Throws Error(InvalidInput, "BadOption") unless the length, mm, is finite, not negative and at
/// most 1e9 mm; 0 where it may be.
void requireLength(const std::string& name, double value, bool mayBeZero);

/// Throws the same for what a setting must not be.
void checkSettings(const ClearanceOptions& options);

}  // namespace swept::clearance
