// Moves vertices out of their cell to the points where their planes meet.
//
// In: the escapes of each layer (vertices whose planes meet outside their cell). Out: moved
// vertices of the dual surface. Units: cells. Cost: a few cell look-ups per escape.
// Promise: the result does not depend on the order of the escapes. Vertices that move into the same
// cell stay at least kMinDistance apart: if two would come nearer, only one moves. Vertices at
// corners have priority over vertices on creases, then shorter moves over longer ones. Mending
// removes the intersections that remain. Source: own method; docs/contouring.md, "Tips".
//
// The tip of a corner or wedge can reach into a neighbouring cell without meeting any edge of that
// cell. If the segment to the tip leads through cells without surface, the vertex moves to the tip.
// If the tip lies in a neighbouring cell with surface, the vertex of a component there may move to
// the tip, provided that all planes of this component pass through the tip. That vertex becomes the
// corner, although the crossings of its cell lie only on some of the corner's planes.
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
  std::uint32_t vertex;      // index in its layer
  Eigen::Vector3d from, to;  // mass point and minimiser, in the coordinates of the cell
  Qef planes;                // in the coordinates of the cell
  double error;              // mean squared distance of the planes from the minimiser
};

/// Moves vertices of `surface`; `escapes` has one list per layer.
void moveTips(const HermiteGrid& grid, ComponentMethod method,
              const std::vector<std::vector<Escape>>& escapes, DualSurface& surface);

}  // namespace swept
