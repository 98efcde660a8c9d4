// What made each triangle of a simplified surface: what made the largest part of its area.
// In: a surface with its sources, a mesh near it. Out: per triangle of the mesh a row of the same
// sources. Units: mm. Cost: up to 16 searches for the nearest triangle of the surface a triangle of
// the mesh; the result does not depend on the threads.
// Where a triangle crosses a border it stands for both sides; a point that lies nearest to a
// triangle which looks the other way (a thin wall) says nothing.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "geometry/nearest_triangle.h"
#include "swept/sources.h"
#include "swept/types.h"

namespace swept {

/// spacing: mm, of the triangles of the surface, about. `nearest`: of the surface.
Sources sourcesOfSimplified(const TriMesh& surface, const NearestTriangle& nearest,
                            const Sources& sources, const TriMesh& mesh, double spacing);

}  // namespace swept
