// SPDX-License-Identifier: LGPL-2.1-or-later
#include "priority.h"

#include <atomic>
#ifdef __linux__
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>
#endif

namespace swept::python {
namespace {

std::atomic<bool> asked{false};
/// Of the scheduler of Linux, 0 to 19: a thread at 0 gets nine times the time of one at 10.
constexpr int kNice = 10;

}  // namespace

void standBack() { asked = true; }

void standBackIfAsked() {
  if (!asked) return;
#ifdef __linux__
  // A priority that cannot be changed is no reason to fail: the run is only less polite.
  static_cast<void>(setpriority(PRIO_PROCESS, static_cast<id_t>(syscall(SYS_gettid)), kNice));
#endif
}

}  // namespace swept::python
