// Tells what made each crossing, in terms of the body and the trajectory as the user gave them.
//
// In: the elements that made the crossings, and the crossings with exact times. Out: a row per
// crossing (swept/sources.h). Units: mm, seconds. Cost: O(crossings), some nanoseconds each; 48
// bytes a crossing. Sampling stores the element of every crossing, so no search is needed. The
// mesh is the same with and without sources, unless the run without them thins the body
// (pipeline/thinned_body.h).
//
// An edge of the body is sharp or smooth as a whole. Where two faces meet along a chain of edges,
// the median of their angles decides, so that coarse triangles do not make some edges of the chain
// sharp and others smooth. If an edge sweeps in the plane of a face beside it, this face slides
// along itself; the row names this face.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "grid/hermite_grid.h"
#include "grid/marked_edges.h"
#include "sampling/sampler.h"
#include "swept/sources.h"

namespace swept {

/// Faces that meet at less than this angle are smooth: 8 degrees, in rad. Where a rounding with 32
/// facets to the circle joins a flat face, the angle is 5.6 degrees.
constexpr double kSmoothAngle = 0.13962634;

/// Returns a row for each crossing. `input.body.faceOf` must have an entry per triangle.
/// `namedFaces` says that a face may have many triangles. `trajectory` holds the poses of the
/// motion; `pose` lists, for each of them, its number in the given trajectory.
std::vector<SurfaceSource> sourcesOfCrossings(const SamplerInput& input,
                                              const std::vector<SweptElement>& elements,
                                              const HermiteGrid& grid, bool namedFaces,
                                              const Trajectory& trajectory,
                                              const std::vector<std::int32_t>& pose);

}  // namespace swept
