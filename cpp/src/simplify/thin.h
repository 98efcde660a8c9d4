// The first stage of simplifying: a dense mesh made thinner by half-edge collapses, which keep a
// subset of the vertices where they are, so that what is fitted to them later stays exact.
// In: a closed manifold mesh of any size, a limit in mm. Out: the smaller mesh, closed and manifold
// as before, with no more pairs of triangles that meet than before.
// Bound: what each collapse moves (the vertex that goes from the new triangles, the middles of new
// edges from the old ones) adds up by vertex to no more than the limit. Neighbours share it, so the
// surface may lie a little farther in places: who promises a distance measures it.
// Order: rounds of growing limits instead of a queue (the order matters little at a small part of
// the final tolerance). Cost: O(n), about 2 us a vertex; the parts of a round do not depend on the
// number of threads.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "swept/run_context.h"
#include "swept/types.h"

namespace swept {

/// What the triangles are thinned for. Surfaces are found by growing over triangles, which stay
/// many and well shaped for it; an edge collapse takes triangles of any shape.
enum class ThinFor { Collapse, Surfaces };

struct Thinned {
  TriMesh mesh;
  std::vector<std::int32_t> source;    ///< by vertex: its number in the mesh before
  std::vector<std::int32_t> triangle;  ///< by triangle: the one before whose place it takes
};

/// `phase`: what the run is told to be doing. `kept`: by vertex, those that stay, with all
/// triangles that touch nothing else; empty: none.
Thinned thinOut(const TriMesh& mesh, double limit, ThinFor purpose, Phase phase, RunContext& run,
                std::vector<char> kept = {});

}  // namespace swept
