// Finds what made each crossing, in terms of the body and the trajectory that the user gave.
//
// In: the elements that made the crossings, and the crossings with exact times. Out: a row per
// crossing (swept/sources.h). Units: mm, seconds. Cost: O(crossings), some nanoseconds each; 48
// bytes per crossing. Sampling stores the element of every crossing, so no search is needed. The
// mesh is the same with and without sources, unless the run without sources thins the body
// (pipeline/thinned_body.h).
//
// An edge between two faces of the body is sharp or smooth as a whole. In the mesh, it is a chain
// of edges with different angles. The median of these angles decides, so that coarse triangles do
// not make some edges of the chain sharp and others smooth. If an edge sweeps in the plane of a
// face beside it, this face slides along itself, and the row names this face as the source.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "grid/hermite_grid.h"
#include "grid/marked_edges.h"
#include "sampling/sampler.h"
#include "swept/sources.h"

namespace swept {

/// If faces meet at a smaller angle, the edge between them is smooth: 8 degrees, in rad. For
/// comparison: where a fillet with 32 facets per full circle joins a flat face, the angle is 5.6
/// degrees.
constexpr double kSmoothAngle = 0.13962634;

/// Returns a row for each crossing. `input.body.faceOf` must have an entry per triangle.
/// `namedFaces`: true if a face may have several triangles. `trajectory`: the poses of the motion.
/// `pose`: for each of them, its index in the trajectory that the user gave.
std::vector<SurfaceSource> sourcesOfCrossings(const SamplerInput& input,
                                              const std::vector<SweptElement>& elements,
                                              const HermiteGrid& grid, bool namedFaces,
                                              const Trajectory& trajectory,
                                              const std::vector<std::int32_t>& pose);

}  // namespace swept
