// What is outside, and whether it is kept out.
// In:    marked edges or a Hermite grid, and the run's inputs. Out: which lattice points the
// outside
//        reaches; warnings in the report; Error(InvalidInput) where there is nothing to contour
//        ("CellTooLarge") or the outside reaches in through an open body ("OpenMesh").
// Cost:  one pass over the marks.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "grid/hermite_grid.h"
#include "pipeline/plan.h"
#include "sampling/sampler.h"
#include "signs/cavities.h"

namespace swept {

/// The outside, and where cavities are kept the hollow spaces that it does not reach.
SignRuns findSigns(const SamplerInput& input, const MarkedEdges& marks, const SolidPoint& isSolid,
                   const Prepared& prepared, bool keepCavities, Report& report, RunContext& run);

/// There must be something to contour, and something must come of it.
void requireCrossings(const HermiteGrid& hermite, const Prepared& prepared, RunContext& run);
void requireSurface(const TriMesh& mesh, const Prepared& prepared, RunContext& run);
/// And the outside must not reach in through an open body.
void requireEnclosed(const HermiteGrid& hermite, const Prepared& prepared, Report& report,
                     RunContext& run);

}  // namespace swept
