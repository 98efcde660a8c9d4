// Which lattice points the outside reaches: runs and union-find instead of a flood over voxels.
//
// Along a lattice line in z the points between two marked edges are one run. Runs of neighbouring
// lines are joined where a lattice edge between them is not marked. Outside = what is joined to the
// corner of the grid. Memory: 4 bytes a line and 5 bytes a run; time linear in runs and marked
// edges.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "grid/grid_plan.h"
#include "grid/marked_edges.h"
#include "swept/run_context.h"

namespace swept {

struct SignRuns {
  std::int32_t columns = 0;             ///< lattice points along y
  std::vector<std::uint32_t> firstRun;  ///< per line (i * columns + j), one past the end at last
  std::vector<std::uint8_t> outside;    ///< per run

  std::uint32_t line(std::int32_t i, std::int32_t j) const {
    return static_cast<std::uint32_t>(i) * static_cast<std::uint32_t>(columns) +
           static_cast<std::uint32_t>(j);
  }
};

/// component: if given, a number per run, the same for runs that are joined.
SignRuns findOutside(const MarkedEdges& marked, const GridPlan& grid, RunContext& run,
                     std::vector<std::uint32_t>* component = nullptr);

}  // namespace swept
