// Runs one job on a thread of its own while this one watches: progress bar, Ctrl-C, exit status.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <string>

#include "swept/run_context.h"
#include "swept/types.h"

namespace swept::cli {

constexpr int kExitOk = 0;
constexpr int kExitFailed = 1;
constexpr int kExitUsage = 2;
constexpr int kExitCancelled = 130;

int exitStatus(Status status);

/// Calls `job` on another thread and waits. Draws a progress bar where standard error is a terminal
/// and `quiet` is false; an interrupt cancels `run`. What the job throws is thrown here.
void runWatched(RunContext& run, bool quiet, const std::function<void()>& job);

/// One line on standard error: "swept: Status/Code: message".
void printError(Status status, const std::string& code, const std::string& message);

}  // namespace swept::cli
