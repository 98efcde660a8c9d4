// What is said of a path that was found or made better. Units: mm, rad.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

#include "path/ends.h"
#include "swept/path.h"

namespace swept::path {

/// The smallest distance that the rows, at least one, guarantee.
double smallestGuaranteed(const std::vector<NeighbourClearance>& rows);

/// The clearance of moves that are proven to keep what was asked for. The rows of the clearance
/// engine are off by up to its tolerance, which may not take away what is proven.
double certainClearance(const std::vector<NeighbourClearance>& rows, const Demand& demand);

/// "path of 8 keys, 468 mm and 124 degrees, clearance at least 1.16 mm"
std::string figuresText(const PathReport& report);

}  // namespace swept::path
