// Finds how deep two closed meshes overlap during a motion, and where.
// In:      a pair of meshes and the tree of the motion (motion_tree.h).
// Out:     the surface point of either mesh that lies deepest inside the other at some time.
// Units:   mm.
// Cost:    branch and bound over time and pieces of surface. Each pair of a time span and a piece
//        takes one nearest-point query and one inside test.
// Why:     The result is exact up to the tolerance. If a point or the surface moves by d, the depth
// of the point changes by at most d. So no point of a box is deeper than the depth at the centre of
// the box + the radius of the box + the displacement.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "clearance/motion_search.h"
#include "swept/clearance.h"

namespace swept::clearance {

/// Finds the deepest point over the motion to within max(tolerance, 1 % of the depth), if `effort`
/// suffices. `effort` limits the number of measured pieces. depthBound is the proven limit. known =
/// false if neither mesh is closed or no point lies inside. The search starts at `touch`, where the
/// surfaces are known to be near.
PenetrationResult deepestPenetration(SearchContext& context, const Minimum& touch, double tolerance,
                                     std::int64_t effort);

/// Returns true only if a surface point of one mesh lies at least `atLeast` (mm) deep inside the
/// other at this pose. May return false although there is such a point, because the effort is
/// limited.
bool overlapsAtLeast(const PairSearch& pair, const Eigen::Matrix3d& R, const Eigen::Vector3d& t,
                     double atLeast);

}  // namespace swept::clearance
