// Chooses the extent and the cell size of the grid before large arrays are allocated.
//
// In: body, motion, options. Out: the grid, with at least one empty cell on every side of the
// sweep. Units: mm. Cost: O(placements + a few times the vertices). Most placements are skipped,
// because the box of the body at the placement lies within the box found so far.
// Source: own method.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Geometry>

#include "grid/grid_plan.h"
#include "motion/motion.h"
#include "swept/run_context.h"
#include "swept/types.h"

namespace swept {

/// Empty cells on each side of the sweep. With this fraction, axis-parallel faces of the sweep
/// seldom pass through lattice points.
constexpr double kGridMarginCells = 1.37;

/// Returns the exact bounding box (mm) of the body's vertices in all placements. The body must have
/// a vertex.
Eigen::AlignedBox3d sweptBox(const TriMesh& body, const Motion& motion, RunContext& run);

/// Returns the cell size (mm): options.cellSize or, if this is not set, the one that gives
/// options.resolution cells along the longest side of the grid.
double plannedCell(const Eigen::AlignedBox3d& box, const Options& options);

/// Plans the grid. Throws Error(InvalidInput) with code "CellTooLarge" or "PrecisionTooCoarse", or
/// Error(ResourceLimit).
GridPlan planGrid(const Eigen::AlignedBox3d& box, const Eigen::AlignedBox3d& bodyBox,
                  const Options& options);

}  // namespace swept
