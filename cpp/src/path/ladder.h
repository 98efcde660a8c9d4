// Tries search methods one after the other, the fastest first, until one finds a path.
// In:      placements to start from and to reach. If several exits lead out of a contact, an end of
//        the path has several placements.
// Out:     keys of a free path from a start to a goal; or the farthest state that was reached.
// Units:   mm, rad.
// Promise: For one seed, the result is the same for any number of threads, unless the time limit
// ends the search. Parallel searches work in rounds of fixed size. If several have a path after the
// same round, the one with the smallest index wins.
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

/// The task of one search. If the part only has to be taken out, `starts` are some placements
/// outside.
struct Leg {
  std::vector<State> starts, goals;
  SearchSpace space;
  bool provable = false;  ///< true: there is one goal, and no contact is allowed around it
  double far = 0;         ///< mm; a straight move of this length leaves all neighbours behind
};

struct LegResult {
  std::vector<State> keys;  ///< empty: no path was found
  std::string method;
  bool noTranslation = false;  ///< proven: no path without turning exists
  State farthest;              ///< the farthest state in the tree of the goal, if no path is found
  std::vector<std::int64_t> blocked;  ///< for each neighbour, how often it blocked a move
  std::int64_t steps = 0;
};

struct Limits {
  const Timer& timer;
  double seconds = 0;
  std::uint64_t seed = 1;
  PathWatch* watch = nullptr;
  /// Largest number of queries of the search in six dimensions; not set: no limit.
  std::optional<std::int64_t> mostSteps;
  bool over() const { return timer.seconds() > seconds; }
};

/// Returns a function that tests whether the part stays within the largest turn from its
/// orientation at the goal during a move.
MoveAllowed turnLimit(const Scene& scene, const SearchSpace& space);

LegResult solveLeg(const Scene& scene, const Rule& rule, const Leg& leg, const Limits& limits,
                   RunContext& run);

}  // namespace swept::path
