// Specks: closed shells round one or two lattice edges, far smaller than a cell.
//
// In: a surface and its intersecting pairs. Out: the surface without specks, and how many there
// were. Units: cells, cubic cells. Cost: O(triangles).
// Source: own argument. The sweep of a connected body is connected. Where the body is thinner than
// the grid resolves, single crossings beyond the thin part become shells of their own. They are
// dropped, and the report says so, so that a solid made from the envelope is one solid. Two
// triangles belong to the same shell if they share a vertex.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "check/mesh_topology.h"
#include "check/self_intersections.h"
#include "contour/surface.h"
#include "swept/run_context.h"

namespace swept {

struct Specks {
  std::int64_t count = 0;
  double largestVolume = 0;  ///< cubic cells
  double largestSize = 0;    ///< cells, diagonal of the box
};

/// Cubic cells: kSpeckVolume limits what counts as a speck of a sweep; kFlatVolume limits what has
/// no inside at all (a shell that mending has flattened).
constexpr double kSpeckVolume = 0.01, kFlatVolume = 1e-9;

/// Drops shells smaller than `maxVolume` cubic cells and 2 cells across, but never the last shell;
/// `pairs` are renumbered.
Specks dropSpecks(Surface& surface, double cell, double maxVolume, SelfIntersections& pairs,
                  RunContext& run);

/// Turns over shells less than 4 cells across that are inside out, which happens to a sheet thinner
/// than the rounding of its vertices. The mesh must be closed and have no misoriented edges.
/// Returns how many were turned.
std::int64_t turnInsideOut(Surface& surface, const MeshTopology& topology, double cell,
                           RunContext& run);

}  // namespace swept
