// Runs long calls. The core computes on a separate thread, without the interpreter lock. Meanwhile,
// the calling thread lets Python handle signals, so Ctrl-C cancels the run at once. Threads of runs
// may get a lower priority than the other threads of the process (priority.h).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <exception>
#include <future>
#include <optional>

#include "priority.h"
#include "swept/run_context.h"

namespace swept::python {

/// Returns job(), computed without the interpreter lock. For short calls, which cannot be
/// cancelled.
template <class Job>
auto withoutLock(const Job& job) {
  const pybind11::gil_scoped_release release;
  return job();
}

template <class Job>
auto runWithoutLock(RunContext& run, Job job) -> decltype(job()) {
  namespace py = pybind11;
  auto done = std::async(std::launch::async, [job = std::move(job)]() mutable {
    applyRunPriority();
    return job();
  });
  std::optional<py::error_already_set> interrupt;
  {
    const py::gil_scoped_release release;
    while (done.wait_for(std::chrono::milliseconds(50)) != std::future_status::ready) {
      const py::gil_scoped_acquire acquire;
      if (!interrupt && PyErr_CheckSignals() != 0) {
        interrupt.emplace();
        run.cancel();
      }
    }
  }
  if (!interrupt) return done.get();
  try {
    done.get();
  } catch (const std::exception&) {
    // The signal cancelled the run, so the caller gets the exception of the signal.
  }
  throw *interrupt;
}

}  // namespace swept::python
