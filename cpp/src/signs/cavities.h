// Finds the enclosed spaces of a sweep that are hollow. If the user requests cavities, the envelope
// keeps these spaces as inner shells.
//
// In: signs, components (sets of connected runs), marked edges, body and motion. Out: the runs of
// hollow components are set to outside, so that their walls contribute like the outer surface.
// Method: no piece of the sweep's boundary passes through a component, so one lattice point
// represents all points of the component. The search follows this point in the body's frame. If the
// point is farther from the body's surface than it can move during a step, it stays inside or
// outside. Otherwise the step is halved. Up to eight points of a component are tested, in the
// middle of its longest runs. The component is hollow if none of these points ever lies in the body
// or close to its surface.
// Precondition: a closed body. Cost: O(components x steps) searches of limited reach.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>

#include "grid/marked_edges.h"
#include "motion/motion.h"
#include "signs/signs.h"
#include "swept/types.h"

namespace swept {

using SolidPoint = std::function<bool(std::int32_t i, std::int32_t j, std::int32_t k)>;

/// Sets the hollow components to outside and returns their number. `component`: the component of
/// each run, from findOutside(). isSolid(i, j, k), if given, returns whether a lattice point is
/// solid in any case. For an offset, these are the points within the offset distance.
std::int64_t openCavities(SignRuns& signs, const std::vector<std::uint32_t>& component,
                          const MarkedEdges& marked, const GridPlan& grid, const TriMesh& body,
                          const Motion& motion, const SolidPoint& isSolid, RunContext& run);

}  // namespace swept
