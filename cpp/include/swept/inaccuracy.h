// Which findings say that a result is less accurate than it was asked for.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "swept/report.h"

namespace swept {

/// Whether a finding of this code costs accuracy.
bool costsAccuracy(const std::string& code);
/// The first one that does; null if none does.
const Finding* inaccuracyOf(const std::vector<Finding>& findings);

}  // namespace swept
