// Other methods to find the components of a cell, for comparison with the consistent one.
//
// In: one cell. Out: a component number per slot. Cost: O(crossings of the cell).
// Promise: none; the surface may be open or non-manifold (docs/contouring.md has figures).
// Source: named at each function.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>

#include "contour/cell.h"
#include "contour/components.h"

namespace swept {

/// Dual marching cubes (Nielson 2004): uses the signs of the corners only, and makes up to four
/// components; on ambiguous faces the inside corners are separated. Edges with both ends outside
/// are dropped.
void findDualMarchingCubes(const Cell& cell, Components& out);

/// Equivalence relation (Varadhan et al. 2003): a crossing belongs to its outside corner; crossings
/// are equivalent if their corners are joined by edges without crossings.
void findEquivalence(const Cell& cell, Components& out);

/// Greedy (thesis section 4.2.2): walks over uncrossed edges, inside and outside, stop at sets of
/// crossings. The set whose normals differ least becomes a component and is removed, and so on. The
/// two cells of a face may decide differently.
void findGreedy(const Cell& cell, const Crossing* crossings, Components& out);

/// Where walks from the corners stop, for one configuration of crossed edges: one set for each
/// group of corners that uncrossed edges join. Bit 2 * edge + direction; direction 0 goes from the
/// low end to the high end.
struct WalkTable {
  struct Entry {
    int count = 0;
    std::array<std::uint32_t, 8> stops{};
  };
  std::array<Entry, 4096> entries;  ///< by edge configuration: bit e is set if edge e is crossed
};
const WalkTable& walkTable();

}  // namespace swept
