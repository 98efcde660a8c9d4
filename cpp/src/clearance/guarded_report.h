// A run that fills a report and never throws but for want of memory: failures become its status,
// code and message.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <tbb/task_arena.h>

#include <new>
#include <string>

#include "base/threads.h"
#include "swept/run_context.h"
#include "swept/types.h"

namespace swept::clearance {

/// Calls work() with the threads of the run. Where it fails, takeBack(report) removes what it has
/// filled in: a run that did not finish must not look like a result. `what` runs, on `inputs`, for
/// messages.
template <class Report, class TakeBack, class Work>
void fillGuarded(Report& report, RunContext& run, const std::string& what,
                 const std::string& inputs, const TakeBack& takeBack, const Work& work) {
  const auto fail = [&](Status status, const std::string& code, const std::string& text) {
    takeBack(report);
    report.status = status;
    report.code = code;
    report.message = text;
  };
  try {
    report.threads = threadsOf(run);
    tbb::task_arena arena(report.threads);
    arena.execute(work);
  } catch (const Error& e) {
    fail(e.status(), e.code(), e.what());
  } catch (const std::bad_alloc&) {
    fail(Status::OutOfMemory, "OutOfMemory",
         "not enough memory for the " + what +
             "; use neighbours with fewer triangles, or fewer neighbours at a time");
  } catch (const std::exception& e) {
    fail(Status::InternalError, "InternalError",
         std::string(e.what()) + ". This is a fault of the program; please report it with " +
             inputs);
  }
}

}  // namespace swept::clearance
