// Specks: closed shells round a single lattice edge or two, far smaller than a cell.
//
// The sweep of a body that hangs together hangs together; where it is thinner than the grid can
// see, single crossings beyond the thin part come out as shells of their own. They are dropped, and
// told: a solid made from the envelope is one solid then. Shells are told apart by their vertices.
// Cost: O(triangles).
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

/// Cubic cells: of what hangs on a sweep, and of what holds nothing at all (a shell that mending
/// has laid flat has no outside).
constexpr double kSpeckVolume = 0.01, kFlatVolume = 1e-9;

/// Drops shells of less than `mostVolume` cubic cells and 2 cells across, never the last shell;
/// `pairs` are brought up to date.
Specks dropSpecks(Surface& surface, double cell, double mostVolume, SelfIntersections& pairs,
                  RunContext& run);

/// Turns over shells less than 4 cells across that came out inside out, as a sheet thinner than the
/// rounding of its vertices may; the mesh is closed, without misoriented edges. Returns how many.
std::int64_t turnInsideOut(Surface& surface, const MeshTopology& topology, double cell,
                           RunContext& run);

}  // namespace swept
