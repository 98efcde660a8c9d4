// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/threads.h"

#include <tbb/info.h>

#include <string>

#include "base/limits.h"
#include "swept/types.h"

namespace swept {

int threadsOf(const RunContext& run) {
  if (run.threads < 0 || run.threads > kMaxThreads) {
    throw Error(Status::InvalidInput, "BadOption",
                "threads is " + std::to_string(run.threads) + "; allowed: 0 (all cores) to " +
                    std::to_string(kMaxThreads));
  }
  return run.threads > 0 ? run.threads : tbb::info::default_concurrency();
}

}  // namespace swept
