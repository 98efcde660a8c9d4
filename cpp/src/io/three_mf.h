// A mesh as 3MF: XML in a packed ZIP file, unit mm.
// In: mesh whose indices are checked. Out: the file in `out`, which can seek. Cost: O(n).
// Throws Error(ExportFailed, "TooManyFaces") where a part would exceed 4 GB; a full disk shows in
// the stream.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ostream>

#include "swept/types.h"

namespace swept {

void writeThreeMf(const TriMesh& mesh, std::ostream& out);

}  // namespace swept
