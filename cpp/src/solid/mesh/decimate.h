// Fewer triangles where no surface was recognised.
// In: HalfEdgeMesh, Partition, tolerance in mm. Triangles of patches keep their patch; triangles
// without one (patchOf < 0) are collapsed edge by edge by the simplifier (simplify/collapse.h), for
// which patches are labels, after the borders of patches were put onto the patches' surfaces. Out:
// the smaller mesh, and the partition for it; may be worked on again. Invariants: closed and
// manifold as before; every removed or moved vertex that did not lie inside a patch stays within
// the tolerance of the new triangles; borders move along themselves only. Paper: quadric error as
// order of the collapses (Garland, Heckbert 1997); the bound is checked on points. Cost: O(n log
// n). SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "geometry/nearest_triangle.h"
#include "solid/mesh/patches.h"

namespace swept::step {

struct Decimated {
  HalfEdgeMesh mesh;
  Partition partition;
  /// By triangle: removed vertices that must stay near it. Empty: none yet.
  std::vector<std::vector<Eigen::Vector3d>> attached;
  std::vector<char> watched;  ///< by triangle: long edges have points among those already
  double deviation = 0;       ///< mm: largest distance of a removed vertex from the new triangles
};

enum class Effort {
  Rough,  ///< only what can be done in parts at the same time: a look at what is to be expected
  Thorough,
  Again,  ///< after patches became open ground: the borders of those that are left stay as they are
};

/// Fewer triangles on open ground at the cost of a few microseconds each, before the first call of
/// decimate(): vertices that touch no patch go where the surface moves by no more than `limit`.
Decimated thinOpenGround(Decimated start, double limit, RunContext& run);

/// `original`: what the triangles of open ground stay near, the mesh before anything was collapsed.
Decimated decimate(Decimated start, double tolerance, const NearestTriangle& original,
                   RunContext& run, Effort effort = Effort::Thorough);

}  // namespace swept::step
