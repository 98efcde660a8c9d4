// Computes the numbers that are reported of a path that was found or improved.
// Units:   mm, rad.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

#include "path/ends.h"
#include "swept/path.h"

namespace swept::path {

constexpr double kPathSpeed = 100;  // mm per second along a path

/// Returns the smallest guaranteed distance of the rows. `rows` must not be empty.
double smallestGuaranteed(const std::vector<NeighbourClearance>& rows);

/// Returns the clearance of a path whose moves are proven to keep the required distances. The
/// guaranteed distances of the rows alone may be smaller by up to one tolerance.
double provenClearance(const std::vector<NeighbourClearance>& rows, const Demand& demand);

/// Checks the motion with checkPair() (clearance/pair_check.h), whose verdict is final. Returns one
/// row for each neighbour that `rule` does not exclude.
std::vector<NeighbourClearance> certificateOf(const Scene& scene, const Demand& demand,
                                              const Trajectory& motion, const Rule& rule,
                                              RunContext& run);
bool allClear(const std::vector<NeighbourClearance>& rows);
/// Transforms placements and points of the rows to the caller's world coordinates.
void toCallerWorld(const Scene& scene, std::vector<NeighbourClearance>& rows);

/// Adds length and total rotation of the path with these keys to the report.
void addLength(const std::vector<State>& keys, PathReport& report);

/// Returns, for example, "path of 8 keys, length 468 mm, total turn 124 degrees, clearance at least
/// 1.16 mm".
std::string figuresText(const PathReport& report);

}  // namespace swept::path
