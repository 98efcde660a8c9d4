// Simplifies the stored surface of an earlier result, so that another tolerance needs no new sweep.
// In:    a result with its stored surface (Simplifier), a tolerance in mm.
// Out:   the same result with a new mesh, contact times, sources and feature edges, checked. Throws
//        Error(InternalError, "CheckFailed") if the mesh does not pass the check.
// Cost:  one simplification and one check.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "swept/compute.h"

namespace swept {

/// Simplifies the surface stored with a result. `tolerance` in mm; 0: no simplification.
void cutKept(Result& result, double tolerance, RunContext& run);

}  // namespace swept
