// Cuts the polygon of a crossing (the four vertices round its lattice edge) into triangles.
//
// In: dual surface. Out: the cut of each quad. Units: cells. Cost: O(1) per crossing.
// Source: Ju and Udeshi 2006: a diagonal is valid only if both triangles stay in the cells round
// the edge. Seen along the edge, the diagonal must pass between the other two corners. A fan is a
// ring of triangles about a new vertex at the crossing.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "contour/dual_surface.h"

namespace swept {

enum class Split : std::uint8_t { Diagonal02, Diagonal13, Fan };

/// Chooses the cut for the crossing at `point`, on a lattice edge along `axis` in layer i.
Split chooseSplit(const DualSurface& dual, int axis, std::int32_t i, const Eigen::Vector3d& point,
                  std::uint32_t crossing);

}  // namespace swept
