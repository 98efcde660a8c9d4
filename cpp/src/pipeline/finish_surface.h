// From a contoured surface to one that may be handed out.
// In:    the surface as contoured, the grid that it came from, the run's inputs.
// Out:   the surface without the pairs of triangles that met, specks and inverted shells that could
//        be dealt with; what the checker found, and warnings, in the report. With consistent
//        components Error(InternalError, "CheckFailed") unless it passes.
// Units: cells; mm in what is told.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>

#include "check/mesh_check.h"
#include "contour/surface.h"
#include "geometry/vertex_move.h"
#include "pipeline/plan.h"

namespace swept {

/// Which vertices of a mesh belong elsewhere, and where. The list: those to look at.
using SettlingMoves =
    std::function<std::vector<VertexMove>(const TriMesh&, const std::vector<std::int32_t>&)>;

struct Finishing {
  const Options& options;
  const Prepared& prepared;
  RunContext& run;
  std::function<void(const char*)> stage;  ///< told the name of each stage at its end
  SettlingMoves settlingMoves = {};        ///< not set: every vertex is where it belongs
};

/// Returns the neighbours of the mesh's triangles, if they were found on the way.
MeshTopology checkAndMend(Surface& surface, const HermiteGrid& hermite, const Finishing& with,
                          Report& report);

}  // namespace swept
