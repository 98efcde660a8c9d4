// Returns the content of a FreeCAD mesh file (.bms).
// In:   a triangle mesh (mm).
// Out:  single precision coordinates and the neighbours of each triangle, so that FreeCAD need not
//       compute them. Cost: O(n).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

#include "swept/types.h"

namespace swept {

std::string freecadMesh(const TriMesh& mesh);

}  // namespace swept
