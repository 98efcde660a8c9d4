// First stage of simplification: thins a dense mesh by half-edge collapses. They keep a subset of
// the vertices in place, so surfaces that are fitted to the vertices later stay exact.
// In:      a closed manifold mesh of any size, and a limit.
// Out:     a smaller closed manifold mesh. It has no more pairs of intersecting triangles than the
//          input.
// Units:   mm.
// Promise: The displacements of the collapses add up, for each vertex, to no more than the limit. A
// displacement is the larger of two distances: of the removed vertex from the new triangles, and of
// the middles of new edges from the old triangles. At folds (folds.h), it is a bound for all points
// around the vertex (mapped_move.h). Each vertex has its own sum, so the surface around several
// moved vertices may deviate slightly more. A caller that needs a bound on the distance must
// measure it, unless the purpose is Sweep.
// Order:   rounds with growing limits instead of a priority queue. The limit is a small part of the
//          final tolerance, so the order of the collapses matters little.
// Cost:    O(n) for n vertices, about 2 us per vertex. Each round works on a fixed number of parts
//        in parallel, so the result does not depend on the number of threads.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "swept/run_context.h"
#include "swept/types.h"

namespace swept {

/// Purpose of the thinning. Surfaces: surface recognition grows over triangles and needs many
/// well-shaped ones. Collapse: edge collapses accept triangles of any shape. Sweep: for a body that
/// is swept, the limit holds everywhere: each mesh lies within the limit of the other
/// (mapped_move.h).
enum class ThinFor { Collapse, Surfaces, Sweep };

struct Thinned {
  TriMesh mesh;
  std::vector<std::int32_t> source;  ///< for each vertex, its index in the input mesh
  /// For each triangle, the triangle of the input mesh that it replaces.
  std::vector<std::int32_t> triangle;
};

/// Returns the thinned mesh. `phase`: the phase for progress reports. `kept`: for each vertex, 1 if
/// it must stay; empty: none must stay. A triangle stays, too, if all its vertices must.
Thinned thinOut(const TriMesh& mesh, double limit, ThinFor purpose, Phase phase, RunContext& run,
                std::vector<char> kept = {});

}  // namespace swept
