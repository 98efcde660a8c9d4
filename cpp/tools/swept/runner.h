// Runs a job on its own thread, while the calling thread shows the progress and handles signals.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "swept/inaccuracy.h"
#include "swept/report.h"
#include "swept/run_context.h"
#include "swept/types.h"

namespace swept::cli {

constexpr int kExitOk = 0;
constexpr int kExitFailed = 1;
constexpr int kExitUsage = 2;
constexpr int kExitNotClear = 3;

/// Returns the exit status of the program. For a cancelled run this is 128 plus the number of the
/// signal, as in shells (130 for Ctrl-C, 143 for SIGTERM).
int exitStatus(Status status);

/// Calls job() on another thread and waits. Draws a progress bar if standard error is a terminal
/// and `quiet` is false. SIGINT, SIGTERM and SIGHUP cancel `run`. Rethrows what job() throws.
void runWatched(RunContext& run, bool quiet, const std::function<void()>& job);

/// Prints one line on standard error: "swept: Status/Code: message".
void printError(Status status, const std::string& code, const std::string& message);
/// Prints one line per finding on standard error. With `quiet`, only findings that cost accuracy.
void printFindings(const std::vector<Finding>& findings, bool quiet);
/// Prints one line per stage on standard error.
void printSeconds(const std::vector<StageSeconds>& seconds);

/// Stores the error that ended a run in the report of any command.
template <class AnyReport>
void takeError(AnyReport& report, Status status, const std::string& code, const std::string& text) {
  report.status = status;
  report.code = code;
  report.message = text;
}
/// With --strict, turns a finding that costs accuracy into the failure of a successful run.
template <class AnyReport>
void takeStrict(AnyReport& report, bool strict) {
  const Finding* finding = strict ? inaccuracyOf(report.warnings) : nullptr;
  if (finding == nullptr || report.status != Status::Ok) return;
  const std::string code = finding->code;
  takeError(report, Status::InvalidInput, code, "--strict: " + finding->text);
}

}  // namespace swept::cli
