// The last gate before a mesh is handed out.
// In:    what the checker found in this run, and the cell. Out: nothing, or Error(InternalError,
//        "CheckFailed") with every fault and its count and what the user can do.
// Units: mm.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "swept/report.h"

namespace swept {

/// `what` names the mesh in the message, such as "the envelope".
void requirePassed(const MeshCheck& check, const char* what, double cell);

}  // namespace swept
