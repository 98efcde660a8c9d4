// Replaces needles, triangles with nearly no height, by exchanging edges.
// In:      a closed mesh.
// Out:     the same mesh with other triangles. Some needles may remain.
// Units:   mm.
// Cost:    O(needles).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <vector>

#include "solid/mesh/half_edge.h"

namespace swept::step {

/// mm: height of a triangle over its longest side; 0 if all corners are one point.
double heightOf(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);
double heightOf(const HalfEdgeMesh& mesh, std::int32_t triangle);

/// Exchanges the longest edge of each triangle that is lower than `height` (mm), if that makes
/// both triangles at the edge higher. `mayFlip(h)`: whether the edge of a half-edge may be
/// exchanged.
void flipNeedles(HalfEdgeMesh& mesh, double height,
                 const std::function<bool(std::int32_t)>& mayFlip);

}  // namespace swept::step
