// Thins a body whose triangles are much smaller than the grid needs, before a long motion. The time
// of the run then depends on the size of the cells, not on that of the triangles.
// In:    a planned motion and the body before its long edges are split.
// Out:   a body with fewer triangles. Each of the two bodies lies within bodyThinning() of the
//        other.
// Units: mm. Cost: about 10 us per triangle, as much as about a hundred placements.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>

#include "pipeline/plan.h"

namespace swept {

/// Returns how far the thinned body may lie from the given one: half of the chord tolerance.
double bodyThinning(const Prepared& prepared, double cell, const Options& options);

/// Returns the thinned body. Returns nothing if the motion is short and keeps the chord tolerance,
/// if the body is not closed or has edges with more than two triangles, or if fewer than half of
/// the triangles would be removed. Also returns nothing if the run needs the given body: a preview
/// keeps it for the next call, sources name its triangles, and offset and conservative envelopes
/// are measured from it.
std::optional<TriMesh> thinnedBody(const Prepared& prepared, const TriMesh& given, double cell,
                                   const Options& options, RunContext& run);

}  // namespace swept
