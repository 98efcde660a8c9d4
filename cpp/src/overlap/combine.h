// The solid that two solids share, or their union, as a mesh.
// In:    two closed meshes, turned outward. Out: a closed mesh, turned outward; empty where they
//        share nothing.
// Units: mm. Cost: O(n log n); two meshes of 70,000 triangles take half a second.
// Method: J. M. Smith, Towards robust inexact geometric computation (2009): which edges go through
//         which triangles is decided exactly, with no two things on each other (lattice.h). Of
//         every triangle the piece inside the other solid is kept. The border of a piece consists
//         of parts of the triangle's own edges, and of segments along which it meets triangles of
//         the other mesh. The neighbour across such an edge, or the triangle that is met, has the
//         same line in its border, the other way round. So all pieces together close, whatever
//         rounding does to the points.
// Promise: closed, every edge passed as often one way as the other; the volume is right to within
//         rounding. Where faces of both lie on each other, triangles without area may hang on it.
//         The same bytes for any number of threads.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

#include "swept/run_context.h"
#include "swept/types.h"

namespace swept::overlap {

struct Combined {
  TriMesh mesh;
  double volume = 0;  ///< mm^3
  double area = 0;    ///< mm^2; a ball of the radius volume / area fits into it
};

/// Which part of each mesh is kept: inside the other one (shared volume) or outside it (union).
enum class Keep { Inside, Outside };

/// Combines two solids that solidOf() made. Throws Error(InvalidInput, "OverlappingShells") if one
/// of them still overlaps itself; Error(Cancelled).
Combined combine(Keep keep, const TriMesh& first, const std::string& firstName,
                 const TriMesh& second, const std::string& secondName, RunContext& run);

}  // namespace swept::overlap
