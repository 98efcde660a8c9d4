// The output of every sampler: for each lattice edge that the swept surface crosses, the first
// crossing from each of the two ends (the crossing "seen" from this end).
//
// Memory: 20 bytes per edge. The size grows with the area of the surface.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace swept {

/// A piece of the swept surface: a face of the body at a placement, or the side patch that an edge
/// of the body sweeps during one motion step.
struct SweptElement {
  static constexpr std::uint32_t kSidePatchBit = 0x80000000u;
  std::uint32_t code = 0;  ///< index of the face; or index of the edge | kSidePatchBit
  /// Placement of the face, or first placement of the side patch's step.
  std::uint32_t placement = 0;

  bool isSidePatch() const { return (code & kSidePatchBit) != 0; }
  std::uint32_t index() const { return code & ~kSidePatchBit; }
};

/// A crossed lattice edge from (i, j, k) towards +axis. Axis, i and j follow from the list that
/// contains the edge.
struct MarkedEdge {
  float lowFraction = 0;   ///< position of the first crossing seen from the low end, in [0, 1]
  float highFraction = 0;  ///< position of the first crossing seen from the high end
  std::uint32_t lowElement = 0, highElement = 0;
  std::uint16_t k = 0;
  std::uint16_t unused = 0;
};

/// Edges that start in lattice layer i. The edges of one axis are ordered by column j, then by k;
/// those of column j are [columnStart[axis][j], columnStart[axis][j + 1]).
struct LayerEdges {
  std::array<std::vector<MarkedEdge>, 3> edges;
  std::array<std::vector<std::uint32_t>, 3> columnStart;
};

/// Finds the edge at (j, k) in the list of one axis of a layer; nullptr if there is none.
template <class Edge>
const Edge* findEdge(const std::vector<Edge>& edges, const std::vector<std::uint32_t>& columnStart,
                     std::int32_t j, std::int32_t k) {
  const auto begin = edges.begin() + columnStart[static_cast<std::size_t>(j)];
  const auto end = edges.begin() + columnStart[static_cast<std::size_t>(j) + 1];
  const auto at = std::lower_bound(begin, end, k,
                                   [](const Edge& e, std::int32_t value) { return e.k < value; });
  return at != end && at->k == k ? &*at : nullptr;
}

struct MarkedEdges {
  std::vector<LayerEdges> layers;      ///< by i
  std::vector<SweptElement> elements;  ///< lowElement and highElement are indices into this

  bool isMarked(int axis, std::int32_t i, std::int32_t j, std::int32_t k) const {
    const LayerEdges& layer = layers[static_cast<std::size_t>(i)];
    return findEdge(layer.edges[axis], layer.columnStart[axis], j, k) != nullptr;
  }
};

}  // namespace swept
