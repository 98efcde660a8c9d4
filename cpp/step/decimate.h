// Fewer triangles where no surface was recognised.
// In: HalfEdgeMesh, Partition, tolerance in mm. Triangles of patches keep their patch; triangles
// without one (patchOf < 0) are collapsed edge by edge. Out: the smaller mesh, and the partition
// for it. Invariants: closed and manifold as before; every removed vertex that did not lie inside a
// patch stays within the tolerance of the new triangles; borders of patches move along themselves
// only. Paper: quadric error as order of the collapses (Garland, Heckbert 1997); the bound is
// checked on points. Cost: O(n log n). SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patches.h"

namespace swept::step {

struct Decimated {
  HalfEdgeMesh mesh;
  Partition partition;
  double deviation = 0;  ///< mm: largest distance of a removed vertex from the new triangles
};

Decimated decimate(const HalfEdgeMesh& mesh, const Partition& partition, double tolerance,
                   RunContext& run);

}  // namespace swept::step
