// Threads of runs that leave the processor to a window's own, which then answers while both
// compute.
//
// The workers of the scheduler inherit the priority of the thread that starts them: asked for
// before the first run, all of them stand back, for the life of the process. Where nobody else
// wants the processor nothing is lost. Linux only; elsewhere nothing happens.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace swept::python {

/// From now on.
void standBack();

/// Called by a thread that begins a run.
void standBackIfAsked();

}  // namespace swept::python
