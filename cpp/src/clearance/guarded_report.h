// Runs a computation that fills a report. Errors become the status, code and message of the report;
// only std::bad_alloc is thrown.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <tbb/task_arena.h>

#include <new>
#include <string>

#include "base/fault_text.h"
#include "base/threads.h"
#include "swept/run_context.h"
#include "swept/types.h"

namespace swept::clearance {

/// Removes all entries of a report but the number of threads. For fillGuarded().
template <class Report>
void keepOnlyThreads(Report& report) {
  const int threads = report.threads;
  report = {};
  report.threads = threads;
}

/// Calls work() with the thread count of the run. If work() fails, removeResults(report) removes
/// partial results, because an unfinished run must not look like a result. In messages, `what`
/// names the computation and `inputs` names its input.
template <class Report, class RemoveResults, class Work>
void fillGuarded(Report& report, RunContext& run, const std::string& what,
                 const std::string& inputs, const RemoveResults& removeResults, const Work& work) {
  const auto fail = [&](Status status, const std::string& code, const std::string& text) {
    removeResults(report);
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
         "there is not enough memory for the " + what +
             "; use parts with fewer triangles, or fewer parts at a time");
  } catch (const std::exception& e) {
    fail(Status::InternalError, "InternalError", e.what() + faultText(inputs));
  }
}

}  // namespace swept::clearance
