// A mesh whose coordinates have single precision, as STL keeps them, and which is still the mesh
// that was checked: rounding to the nearest number can put two vertices in one place, which a
// reader joins, and can leave a triangle without area. In:    mesh, mm. Out: the same triangles;
// every vertex at the nearest number in single precision,
//        or as few steps of it beside as keep vertices apart that were, and every triangle that has
//        area from losing it. Triangles that intersect are not looked for.
// Cost:  O(vertices + triangles). Same result on every machine.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "swept/types.h"

namespace swept {

TriMesh inSinglePrecision(const TriMesh& mesh);

}  // namespace swept
