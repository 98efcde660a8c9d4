// The methods one after the other, from the cheapest, until one finds a path.
// In:    where to start and where to end (each perhaps with several ways out of a contact).
// Out:   free keys from one to the other; or how far the search came. Units: mm, rad.
// Promise: the same for a seed and any count of threads: searches side by side take turns of fixed
//          size, and the first one in their order that has a path is the one that counts.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/timer.h"
#include "path/ends.h"
#include "path/polish.h"
#include "path/two_trees.h"

namespace swept::path {

/// What one search is about. `starts` may be places anywhere outside, where the part is only to
/// get out.
struct Leg {
  std::vector<State> starts, goals;
  SearchSpace space;
  bool provable = false;  ///< one goal, and no contact is allowed round it
  double far = 0;  ///< mm, so long that a straight move along it leaves all neighbours behind
};

struct LegResult {
  std::vector<State> keys;  ///< empty: nothing found
  std::string method;
  bool noTranslation = false;         ///< proven
  State farthest;                     ///< of the goal's tree, if nothing is found
  std::vector<std::int64_t> blocked;  ///< how often each neighbour was in the way
  std::int64_t steps = 0;
};

struct Limits {
  const Timer& timer;
  double seconds = 0;
  std::uint64_t seed = 1;
  PathWatch* watch = nullptr;
  std::int64_t mostSteps = 0;  ///< of the search in six dimensions; 0: no limit
  bool over() const { return timer.seconds() > seconds; }
};

/// Whether a move keeps the largest turn from how the part stands at the goal.
MoveAllowed turnLimit(const Scene& scene, const SearchSpace& space);

LegResult solveLeg(const Scene& scene, const Rule& rule, const Leg& leg, const Limits& limits,
                   RunContext& run);

}  // namespace swept::path
