// For tests: counts the checkpoints of a run, and cancels a run at one of them.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>

#include "swept/run_context.h"

namespace swept {

struct CheckpointHook {
  /// Returns the number of checkpoints that the run has passed so far.
  static std::uint64_t passed(const RunContext& run) {
    return run.checkpoints_.load(std::memory_order_relaxed);
  }
  /// Makes the n-th checkpoint (counted from 1) act as cancel(). Call it before the run starts.
  static void cancelAt(RunContext& run, std::uint64_t n) { run.cancelAt_ = n; }
};

}  // namespace swept
