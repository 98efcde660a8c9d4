// One use of the OpenCASCADE kernel at a time, because its STEP settings and messages are
// process-wide. KernelSession holds the lock, makes the settings, collects the kernel's messages of
// this thread (those of other threads go where they went before), and restores everything.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Message_ProgressIndicator.hxx>
#include <memory>
#include <string>

#include "swept/run_context.h"

namespace swept::step {

class KernelSession {
 public:
  KernelSession();
  ~KernelSession();
  KernelSession(const KernelSession&) = delete;
  KernelSession& operator=(const KernelSession&) = delete;

  /// Sets a text option of the STEP translators until the end of the session.
  void set(const char* name, const std::string& value);
  /// Whether the kernel heals what this thread reads (its default), or leaves it as it is in the
  /// file, until the end of the session. (Kernels from 7.9 on always heal.)
  void setHealing(bool on);
  /// Warnings and failures since the session began, in one line of at most a few hundred
  /// characters.
  std::string messages() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Lets long kernel calls be cancelled and reports them as the run's progress, from `from` to `to`
/// (0 to 1 of the export).
class KernelProgress : public Message_ProgressIndicator {
 public:
  KernelProgress(RunContext& run, double from, double to) : run_(run), from_(from), to_(to) {}

 private:
  Standard_Boolean UserBreak() override { return run_.isCancelled(); }
  void Show(const Message_ProgressScope& scope, Standard_Boolean force) override;
  RunContext& run_;
  double from_, to_;
};

}  // namespace swept::step
