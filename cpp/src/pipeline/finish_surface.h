// Turns a contoured surface into the surface of the result.
// In:    the contoured surface, its grid, the inputs of the run.
// Out:   the surface without intersecting pairs of triangles, specks (tiny separate shells, see
//        contour/mend/specks.h) and inverted shells, as far as they can be repaired. The report
//        gets the findings of the checker and warnings. Throws Error(InternalError, "CheckFailed")
//        if a surface with consistent components does not pass the check.
// Units: cells; mm in the report.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>

#include "check/mesh_check.h"
#include "contour/surface.h"
#include "geometry/vertex_move.h"
#include "pipeline/plan.h"

namespace swept {

/// Returns the vertices that must move, and their new positions. The second argument lists the
/// vertices to inspect.
using SettlingMoves =
    std::function<std::vector<VertexMove>(const TriMesh&, const std::vector<std::int32_t>&)>;

struct Finishing {
  const Options& options;
  const Prepared& prepared;
  RunContext& run;
  std::function<void(const char*)> stage;  ///< receives the name of each stage at its end
  SettlingMoves settlingMoves = {};        ///< empty: no vertex has to move
};

/// Repairs and checks the surface. Returns the adjacency of its triangles; empty if it was not
/// computed.
MeshTopology checkAndMend(Surface& surface, const HermiteGrid& hermite, const Finishing& with,
                          Report& report);

}  // namespace swept
