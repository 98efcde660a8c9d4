// Edges of a model cut in two.
// In: a Model; edges and the parameters at which they are cut, within their ranges. Out: the same
// model with a vertex more for each cut. Units: mm. Cost: O(edges and uses of edges).
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

/// At most one cut an edge.
void splitEdges(const std::vector<EdgeCut>& cuts, Model& model);

}  // namespace swept::step
