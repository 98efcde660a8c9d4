// Cancel flag, progress, budgets of one run. Polled from any thread, never calls back.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <atomic>
#include <cstdint>

namespace swept {

/// Stages of a run in the order in which they are passed; those of a search for a path (Straight to
/// Polish) lie between Motion and Check.
enum class Phase {
  Input,
  Motion,
  Sampling,
  Signs,
  Contour,
  Simplify,
  Check,
  Export,
  Straight,
  Shifts,
  Turns,
  Polish,
  Done
};
constexpr int kPhaseCount = static_cast<int>(Phase::Done) + 1;
const char* phaseName(Phase phase);

/// Shared by the thread that computes and the ones that watch. Not copyable; must outlive the run.
class RunContext {
 public:
  int threads = 0;                     ///< up to 4096; 0: all cores
  std::uint64_t memoryLimitBytes = 0;  ///< 0: three quarters of what the machine has available

  void cancel() { cancelled_.store(true, std::memory_order_relaxed); }
  bool isCancelled() const { return cancelled_.load(std::memory_order_relaxed); }

  Phase phase() const { return static_cast<Phase>(phase_.load(std::memory_order_relaxed)); }
  /// Overall progress, 0 to 1, never falls during a run.
  double progress() const { return progress_.load(std::memory_order_relaxed); }

  /// What follows is one part of a longer run: its progress from 0 to 1 counts as `from` to `to`.
  /// Not while anybody computes.
  void beginPart(double from, double to) {
    from_ = from;
    to_ = to;
  }
  /// Called inside chunk loops. Throws Error(Cancelled) if asked to stop. done/total: of this
  /// phase.
  void checkpoint(Phase phase, std::uint64_t done = 0, std::uint64_t total = 0);
  /// Number of checkpoints passed so far (testing hook).
  std::uint64_t checkpoints() const { return checkpoints_.load(std::memory_order_relaxed); }
  /// Testing hook: behaves as cancel() when the n-th checkpoint (from 1) is reached; 0: off.
  std::uint64_t cancelAtCheckpoint = 0;

 private:
  std::atomic<bool> cancelled_{false};
  std::atomic<int> phase_{0};
  std::atomic<double> progress_{0};
  std::atomic<std::uint64_t> checkpoints_{0};
  double from_ = 0;
  double to_ = 1;
};

}  // namespace swept
