// What is said of a path that was found or made better. Units: mm, rad.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

#include "path/ends.h"
#include "swept/path.h"

namespace swept::path {

constexpr double kPathSpeed = 100;  // mm a second along a path

/// The smallest distance that the rows, at least one, guarantee.
double smallestGuaranteed(const std::vector<NeighbourClearance>& rows);

/// The clearance of moves that are proven to keep what was asked for. The rows of the clearance
/// engine are off by up to its tolerance, which may not take away what is proven.
double certainClearance(const std::vector<NeighbourClearance>& rows, const Demand& demand);

/// The clearance engine has the last word: rows of the neighbours that the rule counts.
std::vector<NeighbourClearance> certificateOf(const Scene& scene, const Demand& demand,
                                              const Trajectory& motion, const Rule& rule,
                                              RunContext& run);
bool allClear(const std::vector<NeighbourClearance>& rows);
/// Places of rows in the caller's world.
void leadOutside(const Scene& scene, std::vector<NeighbourClearance>& rows);

/// Length and turn of a path with these keys.
void takeLength(const std::vector<State>& keys, PathReport& report);

/// "path of 8 keys, 468 mm and 124 degrees, clearance at least 1.16 mm"
std::string figuresText(const PathReport& report);

}  // namespace swept::path
