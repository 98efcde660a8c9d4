// Gives threads of runs a lower priority than the window's thread, so that the window responds
// while both compute.
// The workers of the scheduler inherit the priority of the thread that starts them. If standBack()
// is called before the first run, all workers have the lower priority until the process ends. A run
// loses no time if no other thread needs the processor. Linux only; no effect elsewhere.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace swept::python {

/// Lowers the priority of all later runs.
void standBack();

/// Lowers the priority of the calling thread if standBack() was called. Each run calls this first.
void standBackIfAsked();

}  // namespace swept::python
