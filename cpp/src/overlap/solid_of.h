// Converts the mesh of a part into a solid that can be combined with others.
// In:    any mesh. Out: a welded, closed mesh with normals that point outward. If shells overlap,
//        the mesh is their union.
// Units: mm. Cost: O(n log n) for n triangles; O(n log n log s) for s overlapping shells.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

#include "swept/run_context.h"
#include "swept/types.h"

namespace swept::overlap {

/// Returns the solid. Throws the errors of checkBody(), with `name` before the message,
/// Error(InvalidInput, "OpenMesh") and Error(Cancelled).
TriMesh solidOf(const TriMesh& mesh, const std::string& name, RunContext& run);

}  // namespace swept::overlap
