// Guesses the size of the outer surface of a sweep, from balls around clusters of the body's faces
// on a coarse grid. In: clusters of the body's faces, motion, grid of the run. Out: lattice edges
// of the run's grid that the surface crosses. Cost: O(kMaxBalls), whatever the motion. A guess for
// estimates: between half and three times the true number for bodies of many faces; large faces
// have large balls, and what lies below a coarse cell is not seen.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "grid/grid_plan.h"
#include "motion/motion.h"
#include "sampling/culling/face_clusters.h"

namespace swept {

double guessCrossings(const FaceClusters& clusters, const Motion& motion, const GridPlan& grid);

}  // namespace swept
