// Splits the long edges of a turning body, so that fewer placements suffice for its motion.
// During a turn by the angle a, an edge of length L sweeps a warped patch. The two triangles that
// replace the patch deviate from it by up to L a / 4 (warpOf() in step_path.h). To stay within
// `chord`, the turn needs L a / (4 chord) placements, each with a copy of every face.
// Shorter edges need fewer placements, but give more faces per copy. The number of crossings with
// grid lines depends only on the total area of the copies.
// In:    body, trajectory.
// Out:   the same surface with shorter edges. All triangles of a split edge share the new vertex.
// Units: mm. Cost: O(triangles) per halving.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "swept/run_context.h"
#include "swept/types.h"

namespace swept {

/// The edge length and the chord with which a motion is approximated.
struct MotionApproximation {
  double longestEdge;  ///< mm; edges longer than this are to be split; infinite: none
  double chord;        ///< mm; larger than requested only if there would be too many copies
};

/// Returns the edge length with the shortest sampling time, and the chord to use. Doubles the chord
/// until there are few enough copies of triangles. The limit is `mostCopies`, or twice the number
/// of copies for a chord of one cell if that is more. `maySplit`: false if the body must not be
/// split.
MotionApproximation planApproximation(const TriMesh& body, const Trajectory& trajectory,
                                      double chord, double cell, double mostCopies, bool maySplit,
                                      RunContext& run);

/// Halves all edges longer than `longest` (mm) until there are none. Old vertices keep their
/// indices. The pieces of a triangle belong to the face of that triangle.
TriMesh splitEdges(const TriMesh& body, double longest, RunContext& run);

}  // namespace swept
