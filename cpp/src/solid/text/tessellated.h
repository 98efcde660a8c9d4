// A closed mesh as a tessellated solid of AP242 (ISO 10303-42, tessellated geometry): points and
// triangles, no surfaces. Needs no kernel.
// In: mesh in mm. Out: a file with one TESSELLATED_SOLID for each outer shell, with hollow spaces
// as further faces of it. Cost: O(n). Promise: written beside the target, read back by a separate
// reader, compared (points, triangles, closed, volume), then renamed.
// Throws Error(ExportFailed, "WriteFailed" | "RereadDiffers" | "TooManyFaces" | ...),
// Error(Cancelled).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <istream>
#include <string>

#include "swept/step_export.h"

namespace swept::step {

StepReport writeTessellated(const TriMesh& mesh, const std::string& path,
                            const StepOptions& options, RunContext& run);

/// Approximate size for this number of triangles.
double tessellatedMegabytes(std::int64_t triangles);

/// All triangulated faces of such a file in one mesh. Throws Error(ExportFailed, "RereadFailed").
TriMesh readTessellated(std::istream& text, RunContext& run);

}  // namespace swept::step
