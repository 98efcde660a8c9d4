// Threads of one run.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "swept/run_context.h"

namespace swept {

/// As many as the run is given, all cores for 0. Throws Error(InvalidInput, "BadOption").
int threadsOf(const RunContext& run);

}  // namespace swept
