// Finds patches that are not worth their border.
// In:      a rough simplification of a mesh with patches.
// Out:     patches that save fewer facets than their border on open ground (the triangles without a
//          patch) adds.
// Units:   mm.
// Cost:    O(triangles).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "solid/mesh/decimate.h"

namespace swept::step {

/// `dense` and `first`: the mesh and its patches before the simplification. `now`: both after it.
std::vector<std::int32_t> findCostly(const HalfEdgeMesh& dense, const Partition& first,
                                     const Decimated& now, double tolerance);

}  // namespace swept::step
