// Splits the long edges of a body that turns, so that fewer placements follow its motion.
// The side patch of an edge of length L over a turn by a is warped: its two triangles leave the
// ruled surface by up to L a / 4 (refine_motion.h), which calls for L a / (4 chord) placements,
// each with a copy of every face. Shorter edges need fewer, and cost copies of more faces; lattice
// lines are crossed as often as the copies' area asks.
// In:    body, trajectory. Out: the same surface with shorter edges, conforming: an edge is split
//        for all its triangles alike. Units: mm. Cost: O(triangles) a halving.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "swept/run_context.h"
#include "swept/types.h"

namespace swept {

/// How a motion is followed.
struct Following {
  double longestEdge;  ///< mm, that the body should have; infinite where splitting gains little
  double chord;        ///< mm, larger than asked for only where that would take too many copies
};

/// The edge that takes the least work. `mostCopies` of triangles are allowed, but never less than
/// twice those that a chord of a cell takes. `maySplit`: false if the body stays as it is.
Following planFollowing(const TriMesh& body, const Trajectory& trajectory, double chord,
                        double cell, double mostCopies, bool maySplit, RunContext& run);

/// Halves the edges that are longer than `longest` until none is. Old vertices keep their numbers,
/// the pieces of a triangle its face.
TriMesh splitEdges(const TriMesh& body, double longest, RunContext& run);

}  // namespace swept
