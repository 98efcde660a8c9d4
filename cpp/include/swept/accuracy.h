// Sets cell size and tolerances from one accuracy in mm, and bounds the error of a finished run.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "swept/report.h"
#include "swept/types.h"

namespace swept {

/// Sets cell size, tolerance and chord tolerance so that accuracyBound() of the run is at most
/// `accuracy` (mm, above 0). The bound can be larger if too little memory forces a larger chord
/// tolerance (finding ChordCapped). Throws Error(InvalidInput, "BadOption").
void setAccuracy(Options& options, double accuracy);

/// Returns an upper bound (mm) of the distance between any point of an envelope's surface and the
/// true surface of the sweep. Returns 0 if none is known: for an envelope with an offset, and for a
/// conservative one, which has its own bound. The bound does not cover parts of the sweep that are
/// missing because they are so thin that no grid line meets them. Nor does it cover the errors that
/// the findings DensePruned and SinglePrecision describe.
double accuracyBound(const Report& report);

}  // namespace swept
