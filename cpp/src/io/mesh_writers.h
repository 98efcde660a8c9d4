// Triangles as PLY, OBJ, OFF (each number as it is) and STL (single precision, which is all that
// the format has: io/single_precision.h). Not OpenMesh's writers: they know single precision only.
// Units: mm. Errors stand in the stream.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ostream>

#include "swept/types.h"

namespace swept {

void writePly(const TriMesh& mesh, std::ostream& stream);  ///< binary
void writeObj(const TriMesh& mesh, std::ostream& stream);
void writeOff(const TriMesh& mesh, std::ostream& stream);
/// Binary. The vertices have single precision.
void writeStl(const TriMesh& mesh, std::ostream& stream);

}  // namespace swept
