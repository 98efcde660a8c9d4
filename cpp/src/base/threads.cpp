// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/threads.h"

#include <tbb/info.h>

#include <string>

#include "base/limits.h"
#include "swept/types.h"

namespace swept {

int threadsOf(const RunContext& run) {
  if (!run.threads) return tbb::info::default_concurrency();
  if (*run.threads < 1 || *run.threads > kMaxThreads) {
    throw Error(Status::InvalidInput, "BadOption",
                "threads is " + std::to_string(*run.threads) + "; allowed: 1 to " +
                    std::to_string(kMaxThreads) + ", or not given (all cores)");
  }
  return *run.threads;
}

}  // namespace swept
