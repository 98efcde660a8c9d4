// A path made shorter, with fewer keys.
// In:    keys whose moves are free under a rule. Out: such keys. Units: mm.
// Cost:  a question about a move for each trial; trials are counted, not timed.
// Promise: what comes out is free under the rule that went in; depends on the seed alone.
// Source: shortcuts, R. Geraerts, M. Overmars, Creating high-quality paths for motion planning
// (2007).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <vector>

#include "path/random_numbers.h"
#include "path/scene.h"

namespace swept::path {

/// Whether a move is allowed for other reasons than neighbours (the largest turn).
using MoveAllowed = std::function<bool(const State&, const State&)>;

double lengthOf(const Scene& scene, const std::vector<State>& keys);

/// Shortcuts between random places of the path, then keys left out, until neither helps.
void shorten(const Scene& scene, const Rule& rule, const MoveAllowed& allowed, int trials,
             RandomNumbers& random, std::vector<State>& keys, RunContext& run);

}  // namespace swept::path
