// Gives one thread at a time access to the OpenCASCADE kernel, because its STEP settings and
// messages are process-wide. A KernelSession holds the lock and makes the settings. It collects the
// messages of kernel calls in its thread, and passes on messages of other threads as before. The
// destructor restores the settings and the output of messages.
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
  /// Sets whether the kernel heals the shapes that this thread reads, until the end of the session.
  /// Without healing, shapes stay as they are in the file. (Kernels from 7.9 on always heal.)
  void setHealing(bool on);
  /// Returns the warnings and failures since the session began, in one line of at most a few
  /// hundred characters.
  std::string messages() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Allows long kernel calls to be cancelled. Reports their progress to the run, from `from` to `to`
/// (fractions of the export, 0 to 1).
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
