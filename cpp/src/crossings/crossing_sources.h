// What made each crossing, in terms of the body and of the trajectory as they were given.
//
// In: the elements that won, the crossings with exact times. Out: a row per crossing
// (swept/sources.h). Units: mm, seconds. Cost: O(crossings), some nanoseconds each; 48 bytes a
// crossing. Every crossing knows its element from sampling on, so nothing is searched, and nothing
// that the mesh is made of changes.
// An edge of the body is sharp or smooth as a whole: where the same two faces meet along a chain of
// edges, the median of their angles decides, so that coarse triangles do not tear it to pieces.
// Where an edge sweeps in the plane of a face beside it, the face slides along itself: it is named.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "grid/hermite_grid.h"
#include "grid/marked_edges.h"
#include "sampling/sampler.h"
#include "swept/sources.h"

namespace swept {

/// Faces that meet at less are smooth: 8 degrees, in rad. Triangles of a rounding with 32 sides to
/// the circle leave its neighbour at 5.6 degrees.
constexpr double kSmoothAngle = 0.13962634;

/// `input.body.faceOf`: one for each triangle. namedFaces: they may hold many triangles each. pose:
/// number of each pose of the motion as given.
std::vector<SurfaceSource> sourcesOfCrossings(const SamplerInput& input,
                                              const std::vector<SweptElement>& elements,
                                              const HermiteGrid& grid, bool namedFaces,
                                              const std::vector<std::int32_t>& pose);

}  // namespace swept
