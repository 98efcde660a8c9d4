// The exact crossings of a single element: the reference for what a sampler reports.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "grid/rasterise.h"
#include "sampling/sampler.h"

namespace swept {

/// Calls emit(axis, i, j, k, fraction) for every lattice edge that the triangle crosses.
template <class Emit>
void triangleCrossings(const SnappedPoint& a, const SnappedPoint& b, const SnappedPoint& c,
                       const Emit& emit) {
  using Index = std::int32_t;
  rasteriseTriangle<0>(a, b, c, [&](Index j, Index k, Index i, double f) { emit(0, i, j, k, f); });
  rasteriseTriangle<1>(a, b, c, [&](Index i, Index k, Index j, double f) { emit(1, i, j, k, f); });
  rasteriseTriangle<2>(a, b, c, [&](Index i, Index j, Index k, double f) { emit(2, i, j, k, f); });
}

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
    triangleCrossings(a, b, c, emit);
    triangleCrossings(a, c, d, emit);
  } else {
    const auto& t = input.body.triangles[element.index()];
    triangleCrossings(corner(t[0], k), corner(t[1], k), corner(t[2], k), emit);
  }
}

}  // namespace swept
