// A mesh as 3MF: XML in a packed ZIP file, unit mm.
// In: mesh whose indices are checked. Out: the file, written over an old one. Cost: O(n).
// Throws Error(ExportFailed, "WriteFailed").
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

#include "swept/types.h"

namespace swept {

void writeThreeMf(const TriMesh& mesh, const std::string& path);

}  // namespace swept
