// Finds the pieces of surface in a cell, as closed rings on the walls of the cell.
//
// On each face, chords join the crossings and do not cross each other (components.h). A ring goes
// from crossing to crossing along these chords. So the rings of a cell do not meet, wherever the
// vertices in the cell lie.
// Units: the coordinates of the cell, [0, 1]^3. Cost: O(crossings of the cell).
// Source: own method; docs/contouring.md, "Pairs of triangles that intersect".
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "contour/components.h"

namespace swept {

/// A ring. Its direction makes the triangle (vertex in the cell, slots[n], slots[n + 1]) face
/// outward.
struct CellRing {
  std::vector<std::int8_t> slots;
  std::vector<std::int8_t> faces;  ///< faces[n] has the chord from slots[n] to slots[n + 1]
};

std::vector<CellRing> ringsOf(const Cell& cell, const Crossing* crossings);

/// Returns the fraction of the slot's edge at which the ring crosses the edge. The ring keeps a
/// small distance from the ends of the edge and from the other crossing of the edge. The fraction
/// is the same for all four cells of the edge.
double apartFraction(const Cell& cell, int slot, const Crossing* crossings);
Eigen::Vector3d apartPosition(const Cell& cell, int slot, const Crossing* crossings);

/// Returns a point for the chord of a face between two slots: the middle of the chord, moved into
/// the face if both slots lie on one edge. No other chord of the face lies between the point and
/// the chord.
Eigen::Vector3d chordPoint(const Cell& cell, int face, int from, int to, const Crossing* crossings);

}  // namespace swept
