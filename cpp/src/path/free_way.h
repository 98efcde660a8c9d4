// The way of a part while nothing is there that could be in its way.
// In:    the part, how it comes, how far `along a direction` is. Units: mm.
// Out:   a report as of a path that is found; its clearance is infinite.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "swept/sequence.h"

namespace swept::path {

/// Straight from the start, from so far along the direction, or from the radius above; or the
/// part's own motion.
PathReport freeWay(const SequencePart& part, const PathOptions& options, double far);

}  // namespace swept::path
