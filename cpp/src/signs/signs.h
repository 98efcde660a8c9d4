// Finds the lattice points that are connected with the outside. Uses runs and union-find instead of
// a flood fill over voxels.
//
// In: marked edges. Out: whether each run lies outside. Cost: time linear in runs and marked edges;
// 4 bytes per line and 5 bytes per run.
// Promise: the same result for any number of threads.
// Source: own method; docs/pipeline.md, "Signs".
//
// Along a lattice line in z, the points between two marked edges form a run. Two runs of
// neighbouring lines are joined if a lattice edge between them is not marked. A run is outside if
// it is joined, directly or through other runs, to the run at the corner of the grid.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "grid/grid_plan.h"
#include "grid/marked_edges.h"
#include "swept/run_context.h"

namespace swept {

struct SignRuns {
  std::int32_t columns = 0;  ///< lattice points along y
  /// First run of each line (i * columns + j), with one more entry at the end.
  std::vector<std::uint32_t> firstRun;
  std::vector<std::uint8_t> outside;  ///< per run

  std::uint32_t line(std::int32_t i, std::int32_t j) const {
    return static_cast<std::uint32_t>(i) * static_cast<std::uint32_t>(columns) +
           static_cast<std::uint32_t>(j);
  }
};

/// Finds all runs, and which of them are outside. `component`, if given, receives one number for
/// each run: the same number for runs that are joined, directly or through other runs.
SignRuns findOutside(const MarkedEdges& marked, const GridPlan& grid, RunContext& run,
                     std::vector<std::uint32_t>* component = nullptr);

}  // namespace swept
