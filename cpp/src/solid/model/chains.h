// The borders of patches as chains, and the vertices on them that a solid needs.
// In: HalfEdgeMesh + Partition. Out: Chains; every border edge belongs to one chain, and every
// chain runs from kept vertex to kept vertex, or is closed. Units: mm. Cost: O(n), plus O(length^2)
// at worst for the bends of a chain.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "solid/carrier/carrier.h"
#include "solid/mesh/half_edge.h"
#include "solid/mesh/patches.h"

namespace swept::step {

/// The borders between patches, half-edge by half-edge.
class Borders {
 public:
  Borders(const HalfEdgeMesh& mesh, const Partition& partition)
      : mesh_(mesh), partition_(partition) {}

  std::int32_t patchOf(std::int32_t h) const { return partition_.patchOf[h / 3]; }
  bool isBorder(std::int32_t h) const { return patchOf(h) != patchOf(mesh_.opposite[h]); }

  /// The border half-edge of the same patch that follows h, found by turning in the fan of h.
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
  std::vector<std::int32_t> halfEdges;  ///< in order; all have the same patches on their two sides
  /// The surfaces that fix its points: no facets; a cutting plane last.
  std::vector<const Carrier*> surfaces;
  bool closed = false;
  bool curved = false;    ///< one edge on the curve of intersection of two surfaces
  bool straight = false;  ///< one edge on the line of intersection of two planes

  /// Mesh vertex number i along the chain; there are halfEdges.size() + 1 of them.
  std::int32_t vertex(const HalfEdgeMesh& mesh, std::size_t i) const {
    return i < halfEdges.size() ? mesh.origin(halfEdges[i]) : mesh.target(halfEdges.back());
  }
};

struct Chains {
  std::vector<Chain> chains;
  std::vector<char> kept;  ///< mesh vertices that become vertices of the solid
};

/// tolerance: mm, largest distance of a vertex that is not kept from the straight edge that
/// replaces it.
Chains findChains(const HalfEdgeMesh& mesh, const Partition& partition, double tolerance,
                  RunContext& run);

}  // namespace swept::step
