// The pieces of surface in a cell, as closed rings on the walls of the cell.
//
// On each face the crossings are joined by chords that do not cross (components.h). A ring goes
// from crossing to crossing along these chords; the rings of a cell do not meet, whatever the
// vertices in the cell do.
// Units: the coordinates of the cell, [0, 1]^3. Cost: O(crossings of the cell).
// Source: METHOD.md section 3, number 5.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "contour/components.h"

namespace swept {

/// Runs so that (vertex in the cell, slots[n], slots[n + 1]) faces the outside.
struct CellRing {
  std::vector<std::int8_t> slots;
  std::vector<std::int8_t> faces;  ///< faces[n] has the chord from slots[n] to slots[n + 1]
};

std::vector<CellRing> ringsOf(const Cell& cell, const Crossing* crossings);

/// Where the ring of a slot passes, a little away from the ends of its edge and from the other
/// crossing there. The same for all four cells of the edge.
double apartFraction(const Cell& cell, int slot, const Crossing* crossings);
Eigen::Vector3d apartPosition(const Cell& cell, int slot, const Crossing* crossings);

/// A point on the chord of a face between two slots: its middle, moved into the face where both
/// slots lie on one edge. No other chord of the face lies between it and the chord.
Eigen::Vector3d chordPoint(const Cell& cell, int face, int from, int to, const Crossing* crossings);

}  // namespace swept
