// Finds paths of one to three straight moves.
// In:      placements to start from and to reach.
// Out:     keys from one of the starts to one of the goals with each move proven free; no keys if
//          no such path is found.
// Cost:    some hundred queries about moves.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <vector>

#include "path/polish.h"
#include "path/scene.h"

namespace swept::path {

/// Returns the keys of a path, from one of the starts to one of the goals. Returns no keys if no
/// path was found, or once isLate() is true. `far` (mm): a move of this length leaves all
/// neighbours behind.
std::vector<State> straightMoves(const Scene& scene, const Rule& rule, const MoveAllowed& allowed,
                                 const std::vector<State>& starts, const std::vector<State>& goals,
                                 double far, Memory& memory, const std::function<bool()>& isLate,
                                 RunContext& run);

}  // namespace swept::path
