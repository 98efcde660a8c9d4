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
/// Nice value in Linux, 0 to 19. A thread at 0 gets nine times the time of a thread at 10.
constexpr int kNice = 10;

}  // namespace

void standBack() { asked = true; }

void standBackIfAsked() {
  if (!asked) return;
#ifdef __linux__
  // Failure to change the priority is not an error: the run then only competes with the window.
  static_cast<void>(setpriority(PRIO_PROCESS, static_cast<id_t>(syscall(SYS_gettid)), kNice));
#endif
}

}  // namespace swept::python
