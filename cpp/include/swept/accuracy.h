// Sets cell size and tolerances from one accuracy in mm, and bounds the error of a finished run.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>

#include "swept/report.h"
#include "swept/types.h"

namespace swept {

/// Sets cell size, tolerance and chord tolerance so that accuracyBound() of the run is at most
/// `accuracy` (mm, above 0). The bound can be larger if too little memory forces a larger chord
/// tolerance (finding ChordCapped). Throws Error(InvalidInput, "BadOption").
void setAccuracy(Options& options, double accuracy);

/// Returns an upper bound (mm) of the distance between any point of an envelope's surface and the
/// true surface of the sweep. Returns nothing if none is known: for an envelope with an offset, for
/// a conservative one, which has its own bound, and for a run that failed before sampling. The
/// bound does not cover parts of the sweep that are missing because they are so thin that no grid
/// line meets them. Nor does it cover the errors that the findings DensePruned and SinglePrecision
/// describe.
std::optional<double> accuracyBound(const Report& report);

}  // namespace swept
