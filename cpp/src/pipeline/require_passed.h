// Checks for the last time before a run returns a mesh.
// In:    the findings of the checker in this run, and the cell size. If there are faults, throws
//        Error(InternalError, "CheckFailed") with every fault, its count and advice for the user.
// Units: mm.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "swept/report.h"

namespace swept {

/// Throws unless the mesh has passed the check. `what` names the mesh in the message, such as "the
/// envelope". `cell`: cell size (mm), for the advice.
void requirePassed(const MeshCheck& check, const char* what, double cell);

}  // namespace swept
