// Which enclosed spaces of a sweep are hollow: kept as inner shells where the user asks for it.
//
// In:    signs with their components, marked edges, body and motion. Out: the runs of hollow
//        components are set to outside, so that their walls contribute like the outer surface.
// Method: no piece of the sweep's boundary passes through a component, so one of its lattice points
//        stands for all. The point is followed in the body's frame: while it is farther from the
//        body's surface than it can move, it stays inside or outside; else the step is halved. Up
//        to eight points of a component are queried, those in the middle of its longest runs; it is
//        hollow if the body never contains any of them and they keep clear of its surface.
// Needs a closed body. Cost: O(components x steps) searches of bounded reach.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>

#include "grid/marked_edges.h"
#include "motion/motion.h"
#include "signs/signs.h"
#include "swept/types.h"

namespace swept {

using SolidPoint = std::function<bool(std::int32_t i, std::int32_t j, std::int32_t k)>;

/// Components that were opened. isSolid(i, j, k): lattice points that are solid whatever the body
/// does, for an offset those within the distance; may be empty.
std::int64_t openCavities(SignRuns& signs, const std::vector<std::uint32_t>& component,
                          const MarkedEdges& marked, const GridPlan& grid, const TriMesh& body,
                          const Motion& motion, const SolidPoint& isSolid, RunContext& run);

}  // namespace swept
