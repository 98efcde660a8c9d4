// Runs one job on a thread of its own while this one watches: progress bar, signals, exit status.
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

/// Of a cancelled run: 128 and the number of the signal (130 Ctrl-C, 143 terminated), as shells
/// have it.
int exitStatus(Status status);

/// A full file system, a limit of file sizes or a closed pipe is a failing write, which says its
/// cause, and not the end of the program.
void ignoreWriteSignals();

/// Calls `job` on another thread and waits. Draws a progress bar where standard error is a terminal
/// and `quiet` is false; SIGINT, SIGTERM and SIGHUP cancel `run`. What the job throws is thrown
/// here.
void runWatched(RunContext& run, bool quiet, const std::function<void()>& job);

/// One line on standard error: "swept: Status/Code: message".
void printError(Status status, const std::string& code, const std::string& message);
/// A line each on standard error. `quiet` leaves those out that cost no accuracy.
void printFindings(const std::vector<Finding>& findings, bool quiet);
/// A line a stage on standard error.
void printSeconds(const std::vector<StageSeconds>& seconds);

/// How a run ended, into its report, whichever command's it is.
template <class AnyReport>
void takeError(AnyReport& report, Status status, const std::string& code, const std::string& text) {
  report.status = status;
  report.code = code;
  report.message = text;
}
/// With --strict, a finding that costs accuracy is how an otherwise good run ended.
template <class AnyReport>
void takeStrict(AnyReport& report, bool strict) {
  const Finding* finding = strict ? inaccuracyOf(report.warnings) : nullptr;
  if (finding == nullptr || report.status != Status::Ok) return;
  const std::string code = finding->code;
  takeError(report, Status::InvalidInput, code, "--strict: " + finding->text);
}

}  // namespace swept::cli
