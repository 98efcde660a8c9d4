// Extent and cell of the grid, decided before anything large is allocated.
// In: body, motion, options. Out: the grid, with at least one empty cell to every side of the
// sweep. Units: mm. Cost: O(placements + a few times the vertices), because most placements are
// skipped by their box alone.
// Source: METHOD.md section 1 (empty cells) and section 2, "Traps" (odd offset).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Geometry>

#include "grid/grid_plan.h"
#include "motion/motion.h"
#include "swept/run_context.h"
#include "swept/types.h"

namespace swept {

constexpr double kGridMarginCells =
    /// Empty cells to each side; an odd fraction, so that axis-parallel planes miss lattice points.
    1.37;

/// Exact box of all posed vertices, mm.
Eigen::AlignedBox3d sweptBox(const TriMesh& body, const Motion& motion, RunContext& run);

/// Cell in mm from the options (cellSize, else resolution = cells along the longest side of the
/// grid).
double plannedCell(const Eigen::AlignedBox3d& box, const Options& options);

/// Throws Error(InvalidInput, "CellTooLarge" / "PrecisionTooCoarse"), Error(ResourceLimit).
GridPlan planGrid(const Eigen::AlignedBox3d& box, const Eigen::AlignedBox3d& bodyBox,
                  const Options& options);

}  // namespace swept
