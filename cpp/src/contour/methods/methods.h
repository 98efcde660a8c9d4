// The ways of other methods to find the components of a cell, to be compared with the consistent
// one (docs/contouring.md). None of them promises a closed or manifold surface.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>

#include "contour/cell.h"
#include "contour/components.h"

namespace swept {

/// Dual marching cubes (Nielson 2004): from the signs of the corners alone, up to four components;
/// on ambiguous faces the inside corners are cut off. Edges with both ends outside are left out.
void findDualMarchingCubes(const Cell& cell, Components& out);

/// Equivalence relation (Varadhan et al. 2003): a crossing belongs to its outside corner; crossings
/// are equivalent if their corners are joined by edges without crossings.
void findEquivalence(const Cell& cell, Components& out);

/// Greedy (thesis section 4.2.2): of the sets of crossings at which walks over uncrossed edges
/// stop, inside and outside, the one whose normals differ least is a component; it is taken out,
/// and so on. The two cells of a face may decide differently.
void findGreedy(const Cell& cell, const Crossing* crossings, Components& out);

/// Corner x + 2 y + 4 z of the cell at the low (0) or high (1) end of an edge.
constexpr int cornerOf(int edge, int end) {
  const int a = edge >> 2, b = (a + 1) % 3, c = (a + 2) % 3;
  return end << a | (edge & 1) << b | (edge >> 1 & 1) << c;
}

/// Where walks from the corners stop, for one configuration of crossed edges: one set for each
/// group of corners that uncrossed edges join. Bit 2 * edge + direction; direction 0 is travelled
/// from the low end to the high one.
struct WalkTable {
  struct Entry {
    int count = 0;
    std::array<std::uint32_t, 8> stops{};
  };
  std::array<Entry, 4096> entries;  ///< by edge configuration: bit e set if edge e is crossed
};
const WalkTable& walkTable();

}  // namespace swept
