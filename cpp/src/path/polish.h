// Shortens a path and removes keys from it.
// In:    keys whose moves are free under a rule.
// Out:   keys whose moves are free under the same rule.
// Units: mm.
// Cost:  each trial tests one move or a few. The number of trials is limited, not the time.
// Promise: the result depends on the input and the seed alone.
// Source: shortcuts, R. Geraerts, M. Overmars, Creating high-quality paths for motion planning
// (2007).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <vector>

#include "path/random_numbers.h"
#include "path/scene.h"

namespace swept::path {

/// Returns false for moves that are forbidden for a reason other than neighbours, for example a
/// turn beyond the limit.
using MoveAllowed = std::function<bool(const State&, const State&)>;

/// Number of shortcuts tried in one pass of shorten().
constexpr int kShortcuts = 400;

/// Returns the sum of the distances between consecutive keys, in mm.
double lengthOf(const Scene& scene, const std::vector<State>& keys);

/// Takes shortcuts between random points of the path and removes keys, until neither helps. Tries
/// at most `trials` shortcuts in each of three passes.
void shorten(const Scene& scene, const Rule& rule, const MoveAllowed& allowed, int trials,
             RandomNumbers& random, std::vector<State>& keys, RunContext& run);

}  // namespace swept::path
