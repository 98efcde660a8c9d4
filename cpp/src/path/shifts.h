// Moves without turning: a search over a grid of places, and the proof that there are none.
// In:    the part standing as at the goal. Out: keys from a start to the goal, every move proven
//        free; or that the part cannot leave its goal without turning.
// Units: mm. Grids stand on the goal, along the main axes, and get finer.
// Cost:  a question about a move, or a depth, for every place that is looked at.
// Promise: "proven" is a proof. A cube of places is blocked if in its middle the part lies deeper
//          in a neighbour than half the cube's diagonal reaches, or is nearer by as much than
//          asked; a way without turning from an unblocked cube to another crosses their faces, and
//          the cubes that can be reached from the goal's neither hold the start nor lead out.
// Source: best-first search over cells, J. Barraquand, J.-C. Latombe, Robot motion planning: a
//         distributed representation approach (1991).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "path/scene.h"
#include "path/two_trees.h"

namespace swept::path {

/// Empty if none is found within `places` on every grid.
std::vector<State> shiftsOnly(const Scene& scene, const Rule& rule, const SearchSpace& space,
                              const State& start, const State& goal, int places, Memory& memory,
                              RunContext& run);

/// True: proven that no path without turning leads from the goal to the start, or, without a
/// start, out of the space that is searched.
bool noShifts(const Scene& scene, const Rule& rule, const SearchSpace& space, const State* start,
              const State& goal, int places, RunContext& run);

}  // namespace swept::path
