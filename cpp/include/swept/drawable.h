// Meshes as a 3D view takes them, light enough to be drawn and handed over without a pause.
// In:    closed or open triangle meshes (mm).
// Out:   points with unit normals, single precision, vertices split along creases. Of a mesh with
//        more triangles than asked for, what lies in one cell of a grid becomes one point, where
//        the planes of its triangles meet. To be looked at, not to be measured.
// Cost:  O(n log n); 0.2 s for a million triangles.
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

/// `crease`: rad; edges that turn by more stay sharp.
Drawable drawableOf(const TriMesh& mesh, std::size_t maxTriangles, double crease);

}  // namespace swept
