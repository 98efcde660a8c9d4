// Checks the options of a run (row 16 of docs/bad_input.md).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "swept/types.h"

namespace swept {

/// Checks the options. Throws Error(InvalidInput, "BadOption") with the name, the value and the
/// allowed range.
void checkOptions(const Options& options);
/// Return a tolerance of the options, or its default. They throw the same error if the tolerance is
/// too large for the size of the cells, or for the diagonal of the body's bounding box (both mm).
double chordTolerance(const Options& options, double cell);
double weldTolerance(const Options& options, double diagonal);

}  // namespace swept
