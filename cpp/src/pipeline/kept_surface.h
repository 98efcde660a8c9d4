// The surface that a simplified envelope is cut from, kept so that another tolerance needs no
// sweep. In:    a result with its simplification tree, a tolerance in mm. Out: the same result with
// the
//        mesh, contact times, sources and feature edges of that cut, checked; Error(InternalError,
//        "CheckFailed") unless it passes.
// Cost:  that of the cut and of one check.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "swept/compute.h"

namespace swept {

/// Simplifies the surface that was kept with a result. `tolerance` in mm; 0: no simplification.
void cutKept(Result& result, double tolerance, RunContext& run);

}  // namespace swept
