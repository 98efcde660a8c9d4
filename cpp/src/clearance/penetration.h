// How deep two closed meshes overlap during a motion, and where.
// In:    a pair of meshes, a hierarchy over the motion. Units: mm.
// Out:   the surface point (of either mesh) that lies deepest inside the other at some moment.
// Cost:  branch and bound over moments and surface pieces; each one nearest-point and inside query.
// Why it is exact up to its tolerance: the depth of a point changes by no more than the point or
// the surface moves, so depth at a box's centre + radius + displacement bounds them all.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "clearance/motion_search.h"
#include "swept/clearance.h"

namespace swept::clearance {

/// Deepest point over the motion to within max(tolerance, 1 % of the depth), if `effort` suffices;
/// depthBound tells. known = false if neither mesh is closed or nothing lies inside. `touch`: where
/// the surfaces are known to come near, a good place to begin.
PenetrationResult deepestPenetration(SearchContext& context, const Minimum& touch, double tolerance,
                                     std::int64_t effort);

/// A surface point of one mesh lies at least `atLeast` deep inside the other at this pose. May say
/// no although there is one, if a small effort does not find it.
bool overlapsBy(const PairSearch& pair, const Eigen::Matrix3d& R, const Eigen::Vector3d& t,
                double atLeast);

}  // namespace swept::clearance
