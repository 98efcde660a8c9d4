// Finds the outside of a sweep and checks that the outside does not reach into the body.
// In:    marked edges or a Hermite grid, and the inputs of the run.
// Out:   the lattice points that the outside reaches; warnings in the report.
// Throws Error(InvalidInput, "CellTooLarge") if there is nothing to contour, and
// Error(InvalidInput, "OpenMesh") if the outside enters through holes in an open body.
// Cost:  one pass over the marked edges.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "grid/hermite_grid.h"
#include "pipeline/plan.h"
#include "sampling/sampler.h"
#include "signs/cavities.h"

namespace swept {

/// Finds the outside. With keepCavities, closed hollow spaces count as outside, too.
SignRuns findSigns(const SamplerInput& input, const MarkedEdges& marks, const SolidPoint& isSolid,
                   const Prepared& prepared, bool keepCavities, Report& report, RunContext& run);

/// requireCrossings() throws if no grid line crosses the surface. requireSurface() throws if
/// contouring gave no triangles.
void requireCrossings(const HermiteGrid& hermite, const Prepared& prepared, RunContext& run);
void requireSurface(const TriMesh& mesh, const Prepared& prepared, RunContext& run);
/// Throws if the outside enters through holes of an open body. Only warns if the motion is
/// continuous, or if at most 1 % of the surface has the outside on both sides.
void requireEnclosed(const HermiteGrid& hermite, const Prepared& prepared, Report& report,
                     RunContext& run);

}  // namespace swept
