// Checks of the results of runs in the fuzzing programs, and limits of the time and memory of the
// runs.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <initializer_list>
#include <stdexcept>
#include <string>

#include "swept/run_context.h"
#include "swept/types.h"

namespace swept::fuzz {

class BrokenPromise : public std::logic_error {
 public:
  explicit BrokenPromise(const std::string& what) : std::logic_error(what) {}
};

/// Sets one thread, and a memory limit that keeps a run to about a second. Faults can be found
/// without large grids.
void limit(RunContext& run);

/// Throws BrokenPromise unless a failure has a code, a sentence and one of the allowed statuses.
/// If none are given, all are allowed except InternalError, which means a fault of the program.
void requireNamed(const std::string& what, Status status, const std::string& code,
                  const std::string& message, std::initializer_list<Status> allowed = {});
void requireNamed(const std::string& what, const Error& error,
                  std::initializer_list<Status> allowed = {});

}  // namespace swept::fuzz
