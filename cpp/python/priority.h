// Gives the threads of runs a lower priority than the window's thread, so that the window responds
// while a run computes.
// In Linux, the worker threads of the scheduler inherit the priority of the thread that starts
// them. If lowerRunPriority() is called before the first run, all workers have the lower priority
// until the process ends. A run loses no time if no other thread needs the processor. In other
// systems, only the first thread of a run is sure to have the lower priority.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace swept::python {

/// Lowers the priority of all later runs.
void lowerRunPriority();

/// Lowers the priority of the calling thread if lowerRunPriority() was called. Each run calls this
/// function first.
void applyRunPriority();

}  // namespace swept::python
