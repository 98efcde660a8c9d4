// Vertices whose planes meet outside their cell: whether the vertex, or another one, moves to that
// point.
//
// In: the escapes of each layer. Out: moved vertices of the dual surface. Units: cells. Cost: a few
// cell look-ups per escape.
// Promise: the result does not depend on the order of the escapes. At most one point is granted per
// cell (or several at least kMinDistance apart on one crease); intersections that remain are mended
// later.
// Source: own method; docs/contouring.md, "Tips".
//
// If the path to the point leads through empty cells the vertex moves there: the tip of a corner or
// wedge can reach into a neighbouring cell without meeting any of its edges, and nothing else is in
// that cell. If the point lies in a neighbouring leaf cell, a component there whose own planes
// agree with the point takes it over: it saw only some of the planes of the corner that its cell
// contains.
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

/// Moves vertices of the surface; `escapes` are given per layer.
void moveTips(const HermiteGrid& grid, ComponentMethod method,
              const std::vector<std::vector<Escape>>& escapes, DualSurface& surface);

}  // namespace swept
