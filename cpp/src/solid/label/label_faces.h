// Divides the mesh of an envelope into faces by what made its triangles, instead of guessing.
// In:      the mesh, the sources of its triangles, the body's faces and edges, the trajectory.
// Out:     a Partition whose patches lie on exact carriers. Triangles that no carrier explains stay
//          unassigned. If they are more than half, there are no patches.
// Units:   mm.
// Cost:    O(triangles).
// Method:  1. Each triangle has a crossing, a point of the envelope. Of the carriers that its
//             source allows, the triangle takes the one on which the point lies (swept_carriers.h).
//          2. Ragged borders are cleaned by residual, not by size: a small region goes to a
//             neighbour whose carrier explains its points. Strips narrower than a cell are
//             connected: where two carriers do not meet, the one between them takes the border. The
//             edges of the solid follow the carriers, not the mesh.
//          3. Connected triangles on one carrier form a patch. Patches that close on themselves are
//             cut, so that no face needs a seam.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "solid/mesh/patches.h"
#include "swept/run_context.h"
#include "swept/solid.h"

namespace swept::step {

/// `tolerance`: mm, how far a face may lie from the points that it explains. `open`: points around
/// which the ground stays open, as it then does at corners without a common point.
Partition labelFaces(const HalfEdgeMesh& mesh, const SolidOrigin& origin, double tolerance,
                     const std::vector<Eigen::Vector3d>& open, RunContext& run);

}  // namespace swept::step
