// Rounds the coordinates of a mesh to single precision, the precision of STL, without damaging the
// mesh. Plain rounding can give two vertices the same coordinates, so that a reader joins them. It
// can also leave a triangle without area.
// In:    mesh, mm.
// Out:   the same triangles. Every vertex gets the nearest coordinates in single precision. If two
//        vertices would coincide or a triangle would lose its area, a vertex gets one of the next
//        representable positions instead. Intersections of triangles are not checked.
// Cost:  O(vertices + triangles). The result is the same on every machine.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "swept/types.h"

namespace swept {

TriMesh inSinglePrecision(const TriMesh& mesh);

}  // namespace swept
