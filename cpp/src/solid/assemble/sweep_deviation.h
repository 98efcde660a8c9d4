// Measures how far a solid deviates from the swept volume itself, not from the mesh: along creases
// and on coarse grids, the mesh is less accurate than the solid.
// Units:   mm.
// Cost:    O(log n) for a point near the solid; 2 to 20 queries of swept_interior.h for each of the
//          others, at most 200,000 points.
// Method:  at a point of the mesh that lies off the solid, either the mesh is wrong or the solid.
//          The solid is right if the surface of the swept volume passes its nearest point: some
//          points around it lie inside, others outside. The radius within which this holds is the
//          deviation there.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "solid/assemble/swept_interior.h"
#include "swept/types.h"

namespace swept::step {

/// Returns how far (mm) nine tenths of the points of a mesh may lie off a solid: the tolerance, or
/// 1/250 of the diagonal of the mesh if that is more. A mesh that lies farther off belongs to
/// another motion.
double farthestMesh(const std::vector<Eigen::Vector3d>& points, double tolerance);

struct SweepDeviation {
  double largest = 0;    ///< mm
  double meshError = 0;  ///< mm: nine tenths of the points are this near to the solid, or nearer
};

/// `solid`: triangles of its faces. `points`: on or near the surface of the swept volume, such as
/// the vertices of its mesh. `accuracy`: the smallest radius that is tried. If more than a tenth of
/// the points are farther off than farthestMesh(), they count with their own distances.
SweepDeviation sweepDeviation(const TriMesh& solid, const std::vector<Eigen::Vector3d>& points,
                              const SweptInterior& sweep, double accuracy, double tolerance);

struct FarFoot {
  Eigen::Vector3d point;  ///< on the solid
  std::int32_t face;      ///< TriMesh::faceOf
};

/// Returns the points of the solid that are nearest to some of `points`, but farther than
/// `tolerance` (mm) from the surface of the swept volume.
std::vector<FarFoot> feetBeyond(const TriMesh& solid, const std::vector<Eigen::Vector3d>& points,
                                const SweptInterior& sweep, double accuracy, double tolerance);

}  // namespace swept::step
