// Divides the mesh of an envelope into faces by the sources of its triangles.
// In:      the mesh, the sources of its triangles, the body's faces and edges, the trajectory.
// Out:     a Partition whose patches lie on exact carriers. Triangles that no carrier explains stay
//          unassigned. If they are more than half, there are no patches.
// Units:   mm.
// Cost:    O(triangles).
// Method:  1. Each triangle has a crossing, a point of the envelope. Of the carriers that its
//             source allows, the triangle takes the one on which the point lies (swept_carriers.h).
//          2. Ragged borders are cleaned. A small region joins a neighbour if its points lie near
//             the neighbour's carrier; its size alone does not decide. A strip narrower than a cell
//             can be interrupted: two regions then touch whose carriers do not meet. The triangles
//             along this border go to the carrier of the strip between them. The edges of the solid
//             are computed from the carriers, not from the mesh.
//          3. Connected triangles on one carrier form a patch. Patches that close on themselves are
//             cut, so that no face needs a seam.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "solid/mesh/patches.h"
#include "swept/run_context.h"
#include "swept/solid.h"

namespace swept::step {

/// `tolerance`: mm, how far a face may lie from the points that it explains. `open`: points around
/// which triangles get no carrier and become facets. If `open` is not empty, this also applies
/// around vertices at which the carriers have no common point.
Partition labelFaces(const HalfEdgeMesh& mesh, const SolidOrigin& origin, double tolerance,
                     const std::vector<Eigen::Vector3d>& open, RunContext& run);

}  // namespace swept::step
