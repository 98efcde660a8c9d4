// Writes a closed mesh as a tessellated solid of AP242 (ISO 10303-42): points and triangles, no
// surfaces. Needs no CAD kernel.
// In:      mesh.
// Out:     a file with one TESSELLATED_SOLID for each outer shell. The cavities of a shell are
//          further faces of its solid.
// Units:   mm.
// Cost:    O(n) for n triangles.
// Promise: The file is written beside the target, read back by an independent reader and compared
// (points, triangles, closedness, volume). Only then does it get its final name.
// Throws Error(ExportFailed, "WriteFailed" | "RereadDiffers" | "TooManyFaces" | ...),
// Error(Cancelled).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <istream>
#include <string>

#include "swept/solid.h"

namespace swept::step {

WrittenSolid writeTessellated(const TriMesh& mesh, const std::string& path,
                              const SolidOptions& options, RunContext& run);

/// Returns the approximate file size for this number of triangles, in megabytes.
double tessellatedMegabytes(std::int64_t triangles);

/// Returns all triangulated faces of such a file as one mesh. Throws Error(ExportFailed,
/// "RereadFailed").
TriMesh readTessellated(std::istream& text, RunContext& run);

}  // namespace swept::step
