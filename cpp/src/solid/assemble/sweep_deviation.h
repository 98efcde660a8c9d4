// Measures how far a solid deviates from the swept volume itself, not from the mesh: along creases
// and on coarse grids, the mesh is less accurate than the solid.
// Units:   mm.
// Cost:    O(log n) for a point near the solid; some 20 queries of swept_interior.h for each of the
//          others, which are at most a tenth of the points and at most 20,000.
// Method:  at a point of the mesh that lies off the solid, either the mesh is wrong or the solid.
// The
//          solid is right if the surface of the swept volume passes its nearest point: some points
//          around it lie inside, others outside. The radius within which this holds is the
//          deviation there.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "solid/assemble/swept_interior.h"
#include "swept/types.h"

namespace swept::step {

/// Returns the largest deviation found. `solid`: triangles of its faces. `points`: on or near the
/// surface of the swept volume, such as the vertices of its mesh. `accuracy`: the smallest radius
/// that is tried.
double sweepDeviation(const TriMesh& solid, const std::vector<Eigen::Vector3d>& points,
                      const SweptInterior& sweep, double accuracy);

}  // namespace swept::step
