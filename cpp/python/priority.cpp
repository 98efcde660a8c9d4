// SPDX-License-Identifier: LGPL-2.1-or-later
#include "priority.h"

#include <atomic>

#include "base/system.h"

namespace swept::python {
namespace {

std::atomic<bool> asked{false};

}  // namespace

void standBack() { asked = true; }

void standBackIfAsked() {
  if (!asked) return;
  os::lowerThreadPriority();
}

}  // namespace swept::python
