// Drops specks: closed shells round one or two lattice edges, with a far smaller volume than a
// cell.
//
// In: a surface and its intersecting pairs. Out: the surface without specks, and their number.
// Units: cells, cubic cells. Cost: O(triangles).
// Source: own argument. The sweep of a connected body is connected. Where the body is thinner than
// the grid resolves, single crossings beyond the thin part become separate shells. These shells are
// dropped, so that a solid made from the envelope is one solid. The report gives their number. Two
// triangles belong to the same shell if they share a vertex.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "check/mesh_topology.h"
#include "contour/surface.h"
#include "geometry/self_intersections.h"
#include "swept/run_context.h"

namespace swept {

struct Specks {
  std::int64_t count = 0;
  double largestVolume = 0;  ///< cubic cells
  double largestSize = 0;    ///< cells, diagonal of the box
};

/// Volumes in cubic cells. A speck of a sweep is smaller than kSpeckVolume. A shell smaller than
/// kFlatVolume has no inside, because mending has flattened it.
constexpr double kSpeckVolume = 0.01, kFlatVolume = 1e-9;

/// Drops shells that are smaller than `maxVolume` cubic cells and less than 2 cells across. Drops
/// nothing if all shells are that small. Renumbers `pairs`.
Specks dropSpecks(Surface& surface, double cell, double maxVolume, SelfIntersections& pairs,
                  RunContext& run);

/// Reverses the triangles of shells that are inside out and less than 4 cells across. A sheet
/// thinner than the rounding of its vertices can become such a shell. The mesh must be closed and
/// have no misoriented edges. Returns the number of reversed shells.
std::int64_t turnInsideOut(Surface& surface, const MeshTopology& topology, double cell,
                           RunContext& run);

}  // namespace swept
