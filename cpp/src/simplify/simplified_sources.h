// Finds the source of each triangle of a simplified surface: the source with the largest part of
// its area.
// In:      a surface with its sources, and a simplified mesh near it.
// Out:     for each triangle of the mesh, the index of a row of the same sources.
// Units:   mm.
// Cost:    up to 16 nearest-triangle searches per triangle of the mesh. The result does not depend
//          on the number of threads.
// Limits:  a triangle that crosses the border between two sources gets only one of them. A sample
//          point is ignored if the nearest triangle of the surface faces the other way (thin wall).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "geometry/nearest_triangle.h"
#include "swept/sources.h"
#include "swept/types.h"

namespace swept {

/// Returns the sources of `mesh`. `spacing` (mm) is the typical size of the surface's triangles,
/// `nearest` the search tree of the surface.
Sources sourcesOfSimplified(const TriMesh& surface, const NearestTriangle& nearest,
                            const Sources& sources, const TriMesh& mesh, double spacing);

}  // namespace swept
