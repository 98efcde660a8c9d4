// What a solid is short of its mesh.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "swept/solid.h"

namespace swept {

/// Simplified although no tolerance was given, given up to get a valid one, or farther from the
/// mesh than the tolerance.
std::vector<Finding> solidFindings(const StepReport& solid, const StepOptions& options);

}  // namespace swept
