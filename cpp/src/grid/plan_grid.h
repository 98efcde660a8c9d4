// Extent and cell of the grid, before anything large is allocated.
// In: body, motion. Out: the grid with at least one empty cell to every side of the sweep.
// Cost: O(placements + a few x vertices): most placements are ruled out by their box alone.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Geometry>

#include "grid/grid_plan.h"
#include "motion/motion.h"
#include "swept/run_context.h"
#include "swept/types.h"

namespace swept {

constexpr double kGridMarginCells =
    1.37;  ///< empty cells to each side; odd, so that planes of the body miss it

/// Exact box of all posed vertices, mm.
Eigen::AlignedBox3d sweptBox(const TriMesh& body, const Motion& motion, RunContext& run);

/// Cell from options (cellSize, else resolution = cells along the longest side of the grid).
double plannedCell(const Eigen::AlignedBox3d& box, const Options& options);

/// Throws Error(InvalidInput, "CellTooLarge" / "PrecisionTooCoarse"), Error(ResourceLimit).
GridPlan planGrid(const Eigen::AlignedBox3d& box, const Eigen::AlignedBox3d& bodyBox,
                  const Options& options);

}  // namespace swept
