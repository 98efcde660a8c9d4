// SPDX-License-Identifier: LGPL-2.1-or-later
#include "runner.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <future>

namespace swept::cli {
namespace {

std::atomic<RunContext*> interrupted{nullptr};
static_assert(std::atomic<RunContext*>::is_always_lock_free, "used in a signal handler");

extern "C" void onInterrupt(int) {
  if (RunContext* run = interrupted.load()) run->cancel();
}

// While it lives, an interrupt cancels the run. Another one has no effect, then and afterwards: the
// program is about to end and clears up after itself.
class InterruptGuard {
 public:
  explicit InterruptGuard(RunContext& run) : run_(run) {
    interrupted.store(&run);
    struct sigaction action {};
    action.sa_handler = onInterrupt;
    sigemptyset(&action.sa_mask);
    sigaction(SIGINT, &action, &oldInterrupt_);
    sigaction(SIGTERM, &action, &oldTerminate_);
  }
  ~InterruptGuard() {
    if (run_.isCancelled()) oldInterrupt_.sa_handler = oldTerminate_.sa_handler = SIG_IGN;
    sigaction(SIGINT, &oldInterrupt_, nullptr);
    sigaction(SIGTERM, &oldTerminate_, nullptr);
    interrupted.store(nullptr);
  }
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

 private:
  RunContext& run_;
  struct sigaction oldInterrupt_ {};
  struct sigaction oldTerminate_ {};
};

class ProgressBar {
 public:
  explicit ProgressBar(bool quiet) : shown_(!quiet && isatty(STDERR_FILENO) != 0) {}
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
  return status == Status::Cancelled ? kExitCancelled : kExitFailed;
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

}  // namespace swept::cli
