// Decides which findings mean that a result is less accurate than requested.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "swept/report.h"

namespace swept {

/// Returns whether a finding with this code means a loss of accuracy.
bool costsAccuracy(const std::string& code);
/// Returns the first finding that means a loss of accuracy, or null.
const Finding* inaccuracyOf(const std::vector<Finding>& findings);

}  // namespace swept
