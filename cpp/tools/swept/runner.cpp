// SPDX-License-Identifier: LGPL-2.1-or-later
#include "runner.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <future>

#include "base/system.h"

namespace swept::cli {
namespace {

std::atomic<RunContext*> interrupted{nullptr};
static_assert(std::atomic<RunContext*>::is_always_lock_free, "used in a signal handler");

std::atomic<int> signalNumber{SIGINT};

extern "C" void onInterrupt(int number) {
  signalNumber.store(number);
  if (RunContext* run = interrupted.load()) run->cancel();
}

// While this object exists, signals cancel the run. Later they are ignored, since the program is
// about to end and removes its temporary files.
class InterruptGuard {
 public:
  explicit InterruptGuard(RunContext& run) {
    interrupted.store(&run);
    os::onInterrupt(onInterrupt);
  }
  ~InterruptGuard() {
    os::ignoreInterrupts();
    interrupted.store(nullptr);
  }
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;
};

class ProgressBar {
 public:
  explicit ProgressBar(bool quiet) : shown_(!quiet && os::isTerminal(stderr)) {}
  ~ProgressBar() {
    if (shown_) std::fputs("\r\033[K", stderr);
  }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void draw(const RunContext& run) const {
    if (!shown_) return;
    constexpr int kWidth = 40;
    const double done = std::clamp(run.progress(), 0.0, 1.0);
    const int full = static_cast<int>(done * kWidth);
    const std::string bar = std::string(static_cast<std::size_t>(full), '#') +
                            std::string(static_cast<std::size_t>(kWidth - full), '.');
    std::fprintf(stderr, "\r[%s] %3d %% %s\033[K", bar.c_str(), static_cast<int>(100 * done),
                 run.isCancelled() ? "cancelling" : phaseName(run.phase()));
    std::fflush(stderr);
  }

 private:
  bool shown_;
};

}  // namespace

int exitStatus(Status status) {
  if (status == Status::Ok) return kExitOk;
  return status == Status::Cancelled ? 128 + signalNumber.load() : kExitFailed;
}

void runWatched(RunContext& run, bool quiet, const std::function<void()>& job) {
  const InterruptGuard guard(run);
  const ProgressBar bar(quiet);
  std::future<void> done = std::async(std::launch::async, job);
  while (done.wait_for(std::chrono::milliseconds(100)) != std::future_status::ready) bar.draw(run);
  done.get();
}

void printError(Status status, const std::string& code, const std::string& message) {
  std::string line = message;
  std::replace(line.begin(), line.end(), '\n', ' ');
  const std::string slash = code.empty() || code == statusName(status) ? "" : "/" + code;
  std::fprintf(stderr, "swept: %s%s: %s\n", statusName(status), slash.c_str(), line.c_str());
}

void printFindings(const std::vector<Finding>& findings, bool quiet) {
  for (const Finding& finding : findings) {
    if (quiet && !costsAccuracy(finding.code)) continue;
    std::fprintf(stderr, "swept: note %s: %s\n", finding.code.c_str(), finding.text.c_str());
  }
}

void printSeconds(const std::vector<StageSeconds>& seconds) {
  for (const StageSeconds& stage : seconds)
    std::fprintf(stderr, "swept: %-12s %8.3f s\n", stage.stage.c_str(), stage.seconds);
}

}  // namespace swept::cli
