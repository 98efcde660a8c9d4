// Writes a mesh as 3MF: XML in a compressed ZIP file, unit mm.
// In: mesh with checked indices. Out: the file; an existing file is overwritten. Cost: O(n).
// Throws Error(ExportFailed, "WriteFailed").
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

#include "swept/types.h"

namespace swept {

void writeThreeMf(const TriMesh& mesh, const std::string& path);

}  // namespace swept
