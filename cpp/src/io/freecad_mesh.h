// The bytes of a mesh file of FreeCAD (.bms).
// In:   a triangle mesh (mm). Out: single precision, with the neighbours of each triangle, so that
// nothing is left to be found out by the reader. Cost: O(n).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

#include "swept/types.h"

namespace swept {

std::string freecadMesh(const TriMesh& mesh);

}  // namespace swept
