// Parameters of the thinning, for each purpose. Units: fractions and counts.
// Source: trials with a limit of 0.08 cells on a part with curved and plane faces: the
// fandisk test mesh moved over 16 keys, 1.2 million triangles. The mesh for edge collapses gets a
// quarter of the triangles of the mesh for surface recognition. More rounds do not reduce it
// further.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "simplify/thin.h"

namespace swept {

struct ThinParameters {
  int rounds = 3;      ///< with growing limits
  int lastRounds = 0;  ///< further rounds with the whole limit
  /// Fraction of the limit for the root mean square distance from the planes.
  double meanFraction = 1;
  double minCosine = 0.5;  ///< a triangle may turn by less than 60 degrees
  double minShape = 0.03;  ///< length of the area vector / squared longest side
  double longest = 50;     ///< largest length of a new edge, in mean edge lengths of the input
  /// Also compares new edges with the old triangles. Without this, a spike of 1.1 tolerances
  /// remained on a scanned body (the bunny test mesh moved over 16 keys, 2 mm). Surface recognition
  /// does not need this: surfaces are fitted to the vertices, and the solid is measured at the end.
  bool testsNewEdges = true;
  /// Also bounds the move of folded parts of the surface (mapped_move.h). Without this, a surface
  /// of many thin walls (the station test mesh moved over 16 keys, 256 cells) moved by up to 11
  /// times the limit, and simplifying it took six times as long.
  bool mapsFolds = true;
  bool proven = false;  ///< the limit holds at every point of the surface, in both directions
  /// A triangle below minShape may be replaced by one of about the same shape. Otherwise, a round
  /// rod of very narrow triangles would keep all of them.
  bool mayStayThin = false;
};
inline constexpr ThinParameters kForCollapse;
inline constexpr ThinParameters kForSurfaces{6, 0, 0.35, 0.5, 0.15, 8, false, false};
/// A body that is swept may have triangles of any shape.
inline constexpr ThinParameters kForSweep{8, 4, 1, 0.5, 1e-4, 1e9, false, false, true, true};

inline const ThinParameters& parametersFor(ThinFor purpose) {
  if (purpose == ThinFor::Sweep) return kForSweep;
  return purpose == ThinFor::Collapse ? kForCollapse : kForSurfaces;
}

}  // namespace swept
