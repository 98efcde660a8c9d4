// Gives one thread at a time the use of the OpenCASCADE kernel, whose STEP settings and messages
// are process-wide. KernelSession holds the lock and changes the settings. It collects the kernel's
// messages of this thread and forwards those of other threads. Its destructor restores everything.
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
  /// Sets until the end of the session whether the kernel repairs (heals) the shapes that this
  /// thread reads, which is its default. Kernels from 7.9 on always heal.
  void setHealing(bool on);
  /// Returns the warnings and failures since the session began, in one line of at most a few
  /// hundred characters.
  std::string messages() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Makes long kernel calls cancellable, and reports their progress as a part of the export: from
/// `from` to `to`, both between 0 and 1.
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
