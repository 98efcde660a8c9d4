// Cancel flag, progress and limits of one run. Any thread may poll it; it never calls back.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>

namespace swept {

/// Stages of a run, in their order. The stages of a search for a path (Straight to Polish) lie
/// between Motion and Check.
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

/// Shared by the computing thread and the threads that watch it. Not copyable. Must outlive the
/// run.
class RunContext {
 public:
  std::optional<int> threads;  ///< 1 to 4096; not set: all cores
  /// Not set: three quarters of the memory that is available.
  std::optional<std::uint64_t> memoryLimitBytes;

  void cancel() { cancelled_.store(true, std::memory_order_relaxed); }
  bool isCancelled() const { return cancelled_.load(std::memory_order_relaxed); }

  Phase phase() const { return static_cast<Phase>(phase_.load(std::memory_order_relaxed)); }
  /// Progress of the whole run, 0 to 1. Never decreases during a run.
  double progress() const { return progress_.load(std::memory_order_relaxed); }

  /// Begins one part of a longer run: progress 0 to 1 of the part counts as `from` to `to`. Must
  /// not be called while a computation runs.
  void beginPart(double from, double to) {
    from_ = from;
    to_ = to;
  }
  /// Called inside loops over chunks. Throws Error(Cancelled) if cancel() was called. done/total:
  /// progress within this phase.
  void checkpoint(Phase phase, std::uint64_t done = 0, std::uint64_t total = 0);

 private:
  friend struct CheckpointHook;

  std::atomic<bool> cancelled_{false};
  std::atomic<int> phase_{0};
  std::atomic<double> progress_{0};
  std::atomic<std::uint64_t> checkpoints_{0};  ///< number of checkpoints passed so far
  std::optional<std::uint64_t> cancelAt_;      ///< the checkpoint that acts as cancel()
  double from_ = 0;
  double to_ = 1;
};

}  // namespace swept
