// A dense mesh made thinner before surfaces are looked for: half-edge collapses that keep a subset
// of the vertices where they are, so that what is fitted to them later stays exact.
// In: HalfEdgeMesh (any size), tolerance in mm. Out: the smaller mesh, closed and manifold as
// before. Bound: the planes of the triangles gathered at a vertex have a root mean square distance
// below the tolerance from it, the distances of removed vertices from the new triangles add up to
// no more than it.
// Order: rounds of growing limits instead of a queue (the order matters little at a small part of
// the final tolerance). Cost: O(n), about 2 us a vertex; serial, hence deterministic.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "solid/mesh/half_edge.h"

namespace swept::step {

HalfEdgeMesh thinOut(const HalfEdgeMesh& mesh, double tolerance, RunContext& run);

}  // namespace swept::step
