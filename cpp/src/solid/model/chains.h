// Finds the borders of patches as chains of half-edges, and the vertices on them that the solid
// keeps.
// In:      HalfEdgeMesh and Partition.
// Out:     Chains. Each border edge belongs to exactly one chain. A chain runs from one kept vertex
//        to another, or is closed.
// Units:   mm.
// Cost:    O(n) for n half-edges. Finding the vertices at which a chain of k edges bends takes
//        O(k^2) at worst.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "solid/carrier/carrier.h"
#include "solid/mesh/half_edge.h"
#include "solid/mesh/patches.h"

namespace swept::step {

/// The half-edges on the borders between patches.
class Borders {
 public:
  Borders(const HalfEdgeMesh& mesh, const Partition& partition)
      : mesh_(mesh), partition_(partition) {}

  std::int32_t patchOf(std::int32_t h) const { return partition_.patchOf[h / 3]; }
  bool isBorder(std::int32_t h) const { return patchOf(h) != patchOf(mesh_.opposite[h]); }

  /// Returns the next border half-edge of the same patch, found by turning about the target of h.
  std::int32_t next(std::int32_t h) const {
    std::int32_t n = HalfEdgeMesh::next(h);
    while (!isBorder(n)) n = HalfEdgeMesh::next(mesh_.opposite[n]);
    return n;
  }

 private:
  const HalfEdgeMesh& mesh_;
  const Partition& partition_;
};

struct Chain {
  /// The half-edges in order. The same two patches lie beside all of them.
  std::vector<std::int32_t> halfEdges;
  /// The surfaces on which the chain lies, without facets. A plane that cuts a surface comes last.
  std::vector<const Carrier*> surfaces;
  bool closed = false;
  /// true: becomes a single edge along the curve in which two surfaces intersect
  bool curved = false;
  /// true: becomes a single edge along the line in which two planes intersect
  bool straight = false;

  /// Returns the i-th mesh vertex along the chain, 0 <= i <= halfEdges.size().
  std::int32_t vertex(const HalfEdgeMesh& mesh, std::size_t i) const {
    return i < halfEdges.size() ? mesh.origin(halfEdges[i]) : mesh.target(halfEdges.back());
  }
};

struct Chains {
  std::vector<Chain> chains;
  std::vector<char> kept;  ///< mesh vertices that become vertices of the solid
};

/// Finds the chains. `tolerance`: mm, largest distance of a vertex that is not kept from the
/// straight edge that replaces it.
Chains findChains(const HalfEdgeMesh& mesh, const Partition& partition, double tolerance,
                  RunContext& run);

}  // namespace swept::step
