// An accuracy in mm, in place of a cell size, a tolerance and a chord tolerance.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "swept/report.h"
#include "swept/types.h"

namespace swept {

/// Sets cell size, tolerance and chord tolerance so that accuracyBound() of the run is at most
/// `accuracy` (mm, above 0), unless memory is too short for the chord tolerance (finding
/// ChordCapped). Throws Error(InvalidInput, "BadOption").
void setAccuracy(Options& options, double accuracy);

/// Returns how far (mm) any point of the surface of an envelope lies from the true surface of the
/// sweep, at most. 0: not known, as for an envelope with an offset, or a conservative one, which
/// has a bound of its own. The bound does not tell what is missing: parts of the sweep so thin that
/// no grid line meets them. Nor does it contain what the findings DensePruned and SinglePrecision
/// name.
double accuracyBound(const Report& report);

}  // namespace swept
