// Moves a path farther away from the neighbours that it passes.
// In:    keys whose moves are free under a rule.
// Out:   keys whose moves are free under a rule with larger distances.
// Units: mm, rad.
// Cost:  up to some twenty raises of the rule, each with at most twelve rounds. A round tests each
//        move and collects the contacts at some positions on it.
// Method: At sampled positions, each pair of triangles closer than wanted gives a linear inequality
// for the twists of the two keys beside the position. The smallest twists that satisfy all
// inequalities move the keys. Then the next round samples again.
// Promise: The first and the last key do not change. The result depends only on the input and the
// seed, unless `over` ends the raises.
// Sources: S. Quinlan, O. Khatib, Elastic bands: connecting path planning and control (1993). The
//          smallest twists by dual coordinate ascent: C. Hildreth, A quadratic programming
//          procedure (1957).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <vector>

#include "path/polish.h"

namespace swept::path {

struct WidenLimits {
  MoveAllowed allowed;
  bool turns = true;           ///< whether the part may turn
  std::function<bool()> over;  ///< returns true when no further raise may begin
};

/// Raises all distances of the rule by the same amount. The ends of the path and the neighbours
/// limit this amount, and the path may become at most a quarter longer. A path of one move does not
/// change. Returns the amount in mm. Returns 0 and keeps the keys if no move came close to a
/// neighbour.
double widen(const Scene& scene, const Rule& rule, const WidenLimits& limits, RandomNumbers& random,
             std::vector<State>& keys, RunContext& run);

}  // namespace swept::path
