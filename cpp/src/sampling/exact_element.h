// Computes the exact crossings of a single element, as a reference for testing samplers.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "grid/rasterise.h"
#include "sampling/sampler.h"

namespace swept {

template <class Emit>
void elementCrossings(const SamplerInput& input, const SweptElement& element, const Emit& emit) {
  const auto corner = [&](std::int32_t vertex, std::size_t placement) {
    return snap(input.grid.toGrid(input.motion.placements[placement]),
                input.body.vertices[static_cast<std::size_t>(vertex)]);
  };
  const std::size_t k = element.placement;
  if (element.isSidePatch()) {
    const BodyEdge& e = input.topology.edges[element.index()];
    const SnappedPoint a = corner(e.a, k), b = corner(e.b, k), c = corner(e.b, k + 1),
                       d = corner(e.a, k + 1);
    rasteriseAllAxes(a, b, c, emit);
    rasteriseAllAxes(a, c, d, emit);
  } else {
    const auto& t = input.body.triangles[element.index()];
    rasteriseAllAxes(corner(t[0], k), corner(t[1], k), corner(t[2], k), emit);
  }
}

}  // namespace swept
