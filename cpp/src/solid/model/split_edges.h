// Splits edges of a model in two.
// In:      a Model; edges, each with the curve parameter of the split, inside its range.
// Out:     the same model with one more vertex per split.
// Units:   mm.
// Cost:    O(edges and uses of edges).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "solid/model/model.h"

namespace swept::step {

struct EdgeCut {
  std::int32_t edge = 0;
  double at = 0;  ///< parameter of the edge's curve
};

/// Returns the parameter at which a curve should be halved. For a spline, this is the inner knot
/// nearest to the middle, because a profile may bend unevenly at its knots.
double middleOf(const Curve& curve);

/// Splits edges. Each edge may occur only once in `cuts`.
void splitEdges(const std::vector<EdgeCut>& cuts, Model& model);

}  // namespace swept::step
