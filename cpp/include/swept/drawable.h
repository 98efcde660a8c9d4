// Converts meshes for display in a 3D view. The result is small enough to be copied and drawn
// without a pause.
// In:    closed or open triangle meshes (mm).
// Out:   points with unit normals in single precision; vertices are duplicated along creases. If
//        the mesh has too many triangles, all its vertices in one cell of a grid become one point.
//        It is placed where the planes of the triangles meet. The result is for display, not for
//        measuring.
// Cost:  O(n log n) for n triangles; 0.2 s for a million.
// Paper: Lindstrom 2000, out-of-core simplification (the point of a cell).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>

#include "swept/types.h"

namespace swept {

struct Drawable {
  std::vector<Eigen::Vector3f> points, normals;
  std::vector<std::int32_t> indices;  ///< three points and -1 for each triangle
};

/// `crease`: angle in rad; edges where the surface turns by more than this stay sharp.
Drawable drawableOf(const TriMesh& mesh, std::size_t maxTriangles, double crease);

}  // namespace swept
