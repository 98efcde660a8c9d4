// Other methods to find the components of a cell, for comparison with the consistent method.
//
// In: one cell. Out: a component number per slot. Cost: O(crossings of the cell).
// Promise: none; the surface may be open or non-manifold (figures in docs/contouring.md).
// Source: named at each function.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>

#include "contour/cell.h"
#include "contour/components.h"

namespace swept {

/// Dual marching cubes (Nielson 2004). Uses only the signs of the corners and makes up to four
/// components. Separates the inside corners on ambiguous faces. Drops edges with both ends outside.
void findDualMarchingCubes(const Cell& cell, Components& out);

/// Equivalence relation (Varadhan et al. 2003). A crossing belongs to the outside corner from which
/// it is seen. Crossings are equivalent if their corners are connected by edges without crossings.
void findEquivalence(const Cell& cell, Components& out);

/// Greedy (J. Brummer, bachelor's thesis, Mainz 2017, section 4.2.2). Walks start at every corner,
/// follow uncrossed edges and stop at a set of crossings. The set whose normals differ least
/// becomes a component, its crossings are removed, and the search repeats. Two cells that share a
/// face may pair its crossings differently.
void findGreedy(const Cell& cell, const Crossing* crossings, Components& out);

/// Table of all walks over uncrossed edges, one entry for each configuration of crossed edges. An
/// entry has one set of stops for each group of corners that are connected by uncrossed edges. Bit
/// 2 * edge + direction is set if a walk from the group stops on that edge. Direction 0 leads from
/// the low end of the edge to its high end.
struct WalkTable {
  struct Entry {
    int count = 0;
    std::array<std::uint32_t, 8> stops{};
  };
  std::array<Entry, 4096> entries;  ///< index: bit e is set if edge e is crossed
};
const WalkTable& walkTable();

}  // namespace swept
