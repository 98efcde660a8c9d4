// Tasks that use loops over all cores themselves and may fail. Same failure for any number of
// threads: that of the first task that fails.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>

#include "base/parallel.h"

namespace swept {

/// As parallelFor(), but an exception leaves the loop only when the other tasks are done. Were it
/// to leave its task at once, it would cancel the loops within the tasks beside it: these return
/// early and say nothing, and what follows them would read half of their results.
template <class Body>
void parallelTasks(std::size_t n, const Body& body) {
  std::atomic<std::size_t> first{n};
  std::mutex mutex;
  std::exception_ptr what;
  parallelFor(n, [&](std::size_t i) {
    if (i > first.load()) return;  // what comes after a failure is not wanted
    try {
      body(i);
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (i >= first.load()) return;
      first = i;
      what = std::current_exception();
    }
  });
  if (what) std::rethrow_exception(what);
}

}  // namespace swept
