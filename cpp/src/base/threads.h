// Number of threads of a run.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "swept/run_context.h"

namespace swept {

/// Returns the number of threads of the run; without a setting, one for each core. Throws
/// Error(InvalidInput, "BadOption").
int threadsOf(const RunContext& run);

}  // namespace swept
