// Writes triangles as PLY, OBJ and OFF (every number exactly) and as STL, whose format only holds
// single precision (io/single_precision.h). OpenMesh's writers would use single precision only.
// Units: mm. Only the state of the stream tells whether an error occurred.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ostream>

#include "swept/types.h"

namespace swept {

void writePly(const TriMesh& mesh, std::ostream& stream);  ///< binary
void writeObj(const TriMesh& mesh, std::ostream& stream);
void writeOff(const TriMesh& mesh, std::ostream& stream);
/// Writes binary STL. Rounds the vertices to single precision.
void writeStl(const TriMesh& mesh, std::ostream& stream);

}  // namespace swept
