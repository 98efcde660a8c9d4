// The borders of patches as chains, and the vertices on them that a solid needs.
// In: HalfEdgeMesh + Partition. Out: Chains; every border edge is in one chain, every chain runs
// from kept vertex to kept vertex, or round once. Units: mm. Cost: O(n) but for the chains' bends,
// O(length^2) at worst.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "solid/carrier/surface.h"
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

  /// The border half-edge of the same patch that follows h, turning within the fan of h.
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
  std::vector<std::int32_t> halfEdges;   ///< in order, all with the same patch on either side
  std::vector<const Surface*> surfaces;  ///< those that fix its points: not facets; a cut last
  bool closed = false;
  bool curved = false;    ///< one edge on the curve in which two surfaces meet
  bool straight = false;  ///< one edge on the line in which two planes meet

  /// Vertex i of the mesh along the chain, of halfEdges.size() + 1.
  std::int32_t vertex(const HalfEdgeMesh& mesh, std::size_t i) const {
    return i < halfEdges.size() ? mesh.origin(halfEdges[i]) : mesh.target(halfEdges.back());
  }
};

struct Chains {
  std::vector<Chain> chains;
  std::vector<char> kept;  ///< mesh vertices that become vertices of the solid
};

/// tolerance: mm, how far a vertex that is not kept may lie off the straight edge in its place.
Chains findChains(const HalfEdgeMesh& mesh, const Partition& partition, double tolerance,
                  RunContext& run);

}  // namespace swept::step
