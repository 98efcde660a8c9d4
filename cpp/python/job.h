// Long calls: the core runs on a thread of its own without the interpreter's lock, while this
// thread lets Python handle its signals, so that Ctrl-C cancels the run instead of waiting for its
// end. The threads of runs may be told to stand back behind the others of the process.
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

template <class Job>
auto runWithoutLock(RunContext& run, Job job) -> decltype(job()) {
  namespace py = pybind11;
  auto done = std::async(std::launch::async, [job = std::move(job)]() mutable {
    standBackIfAsked();
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
    // The run was cancelled by the signal: the signal is what the caller has to see.
  }
  throw *interrupt;
}

}  // namespace swept::python
