// SPDX-License-Identifier: LGPL-2.1-or-later
#include "priority.h"

#include <atomic>

#include "base/system.h"

namespace swept::python {
namespace {

std::atomic<bool> lowered{false};

}  // namespace

void lowerRunPriority() { lowered = true; }

void applyRunPriority() {
  if (!lowered) return;
  os::lowerThreadPriority();
}

}  // namespace swept::python
