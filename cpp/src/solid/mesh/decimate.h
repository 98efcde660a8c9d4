// Reduces the triangles that belong to no patch, because no surface was recognised there. They are
// called open ground.
// In:      HalfEdgeMesh, Partition, tolerance. Triangles of patches keep their patch. In open
//          ground (patchOf < 0), edges are collapsed (simplify/collapse.h; patches are called
//          labels in that file). Before that, the borders of patches are moved onto the surfaces of
//          the patches.
// Out:     the reduced mesh and its partition. The result may be the input of a further call.
// Units:   mm.
// Promise: The mesh stays closed and manifold. Each removed or moved vertex outside the patches
//          stays within the tolerance of the new triangles. A border vertex collapses only along
//          its border.
// Paper:   quadric error as the order of the collapses (Garland, Heckbert 1997). The bound is
//          checked on sample points.
// Cost:    O(n log n).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "geometry/nearest_triangle.h"
#include "solid/mesh/patches.h"

namespace swept::step {

struct Decimated {
  HalfEdgeMesh mesh;
  Partition partition;
  /// For each triangle, removed vertices that must stay near it. Empty before the first call.
  std::vector<std::vector<Eigen::Vector3d>> attached;
  /// For each triangle, 1 if `attached` already has points on its long edges.
  std::vector<char> watched;
  double deviation = 0;  ///< mm: largest distance of an attached point from its triangle
  /// For each vertex, 1 if it must stay although it is on a border. Then borders do not move onto
  /// surfaces. Empty: none.
  std::vector<char> fixed = {};
};

enum class Effort {
  Rough,  ///< only the collapses that run in parallel, for a first estimate
  Thorough,
  Again,  ///< a further call, after patches became open ground; the remaining borders do not move
};

/// Limit of thinning, as a fraction of the tolerance of the solid. Without thinning, the edge
/// collapse of 500,000 triangles took two thirds of the time of an export.
constexpr double kThinFraction = 0.15;

/// Returns the mesh as open ground only.
Decimated asOpenGround(HalfEdgeMesh mesh);

/// Thins open ground at a few microseconds per triangle, before the first call of decimate().
/// Removes vertices without a patch if the surface moves by at most `limit`.
Decimated thinOpenGround(Decimated start, double limit, RunContext& run);

/// Returns the reduced mesh. `original`: the mesh before any collapse; triangles of open ground
/// stay near it.
Decimated decimate(Decimated start, double tolerance, const NearestTriangle& original,
                   RunContext& run, Effort effort = Effort::Thorough);

}  // namespace swept::step
