// What the process uses and what the machine has.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>

#include "swept/run_context.h"

namespace swept {

/// Starts a new peak at the present use (Linux; elsewhere the peak is that of the process so far).
void resetPeakMemory();
/// Largest resident size since then, bytes; 0 where the system does not tell.
std::uint64_t peakMemoryBytes();
/// Memory that could be taken without swapping, bytes; 0 where the system does not tell.
std::uint64_t availableMemoryBytes();
/// What a run may take: its own limit, else three quarters of what is available; 0: not known.
std::uint64_t memoryLimit(const RunContext& run);

/// Hands free memory back to the system: the allocator keeps what many threads have freed, several
/// times what a run needs, until somebody asks. Milliseconds; nothing where there is no such call.
void returnFreeMemory();

}  // namespace swept
