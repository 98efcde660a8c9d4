// Vertices whose planes meet outside their cell: what becomes of the point where they meet.
//   Its way leads through empty cells: the vertex may follow (the tip of a corner or wedge can
//   reach into a neighbour without meeting any of its edges; nothing else lives there). It lies in
//   a neighbouring leaf cell: a component there whose own planes agree with it takes it (it saw
//   only some of the planes of the corner that it holds).
// A cell is given one point only; whatever still meets is found and mended later.
// Units: cells. Cost: a few cell look-ups an escape.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "contour/dual_surface.h"
#include "contour/qef.h"

namespace swept {

/// A vertex whose planes meet outside its cell.
struct Escape {
  std::uint32_t vertex;      // in its layer
  Eigen::Vector3d from, to;  // mass point and minimiser, in the cell's coordinates
  Qef planes;                // in the cell's coordinates
  double error;              // mean squared distance of the planes from the minimiser
};

/// Per layer, the escapes of its vertices. Moves vertices of the surface; the result does not
/// depend on the order.
void placeTips(const HermiteGrid& grid, ComponentMethod method,
               const std::vector<std::vector<Escape>>& escapes, DualSurface& surface);

}  // namespace swept
