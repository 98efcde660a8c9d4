// A part as a solid that can be combined with others.
// In:    any mesh. Out: welded, turned outward, closed; of shells that overlap their union.
// Units: mm. Cost: O(n log n), with overlapping shells O(n log n log shells).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

#include "swept/run_context.h"
#include "swept/types.h"

namespace swept::overlap {

/// Throws what checkBody() throws, with the name before it; Error(InvalidInput, "OpenMesh"),
/// Error(Cancelled).
TriMesh solidOf(const TriMesh& mesh, const std::string& name, RunContext& run);

}  // namespace swept::overlap
