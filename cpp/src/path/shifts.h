// Finds paths on which the part does not turn, by a search over a grid of placements. Can also
// prove that there is no such path.
// In:      the part in its orientation at the goal.
// Out:     keys from a start to the goal with each move proven free; or a proof that the part
//          cannot leave its goal without turning.
// Units:   mm. Grids are centred on the goal, aligned with the main axes, and become finer.
// Cost:    per placement that is examined, one query about a move or about a depth.
// Promise: provesNoTranslation() returns true only with a proof. Consider the part at the middle of
// a cube of placements. The cube counts as blocked if the part lies deeper in a neighbour there
// than half the diagonal of the cube. It is also blocked if the part is nearer than required by
// more than half the diagonal. A path without turning passes from cube to cube through their faces.
// So no path exists if the unblocked cubes connected to the goal neither contain the start nor lead
// out.
// Source:  best-first search over cells: J. Barraquand, J.-C. Latombe, Robot motion planning: a
//          distributed representation approach (1991).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "path/scene.h"
#include "path/two_trees.h"

namespace swept::path {

class GridSearch;

/// Searches grids of placements for each pair of a start and a goal, one grid after the other. The
/// search can be continued step by step, in parallel to other searches.
class ShiftSearch {
 public:
  /// `maxPlacements`: largest number of placements that are examined on one grid.
  ShiftSearch(const Scene& scene, const Rule& rule, const SearchSpace& space,
              const std::vector<State>& starts, const std::vector<State>& goals, int maxPlacements);
  ~ShiftSearch();

  /// Examines up to `count` more placements; fewer if the run is cancelled.
  void advance(int count, const RunContext& run);
  /// Returns the keys from a start to a goal. Empty: no path is found yet.
  const std::vector<State>& path() const { return path_; }
  /// Returns true if all grids are searched or a path is found.
  bool isOver() const;
  const Memory& memory() const { return memory_; }
  /// Returns the farthest placement from which free moves lead to a goal.
  const State& farthest() const { return farthest_; }

 private:
  void begin();

  const Scene& scene_;
  const Rule& rule_;
  const SearchSpace& space_;
  const std::vector<State>& starts_;
  const std::vector<State>& goals_;
  const int maxPlacements_;
  Memory memory_;
  State farthest_;
  std::size_t number_ = 0;  ///< number of the present grid
  std::unique_ptr<GridSearch> grid_;
  std::vector<State> path_;
};

/// Returns true only if it is proven that no path without turning leads from the goal to the start.
/// If `start` is null, the proof is that no such path leads out of the search space. Gives up once
/// isLate() is true.
bool provesNoTranslation(const Scene& scene, const Rule& rule, const SearchSpace& space,
                         const State* start, const State& goal, int maxPlacements,
                         const std::function<bool()>& isLate, RunContext& run);

}  // namespace swept::path
