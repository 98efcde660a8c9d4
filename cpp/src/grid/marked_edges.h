// What a sampler hands on: for every lattice edge that the swept surface crosses, the first
// crossing seen from each end. Memory grows with the surface: 20 bytes an edge.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace swept {

/// A piece of the swept surface: a face of the body at a placement, or the side patch that an edge
/// of the body sweeps during a motion step.
struct SweptElement {
  static constexpr std::uint32_t kPatchBit = 0x80000000u;
  std::uint32_t code = 0;       ///< face index, or edge index | kPatchBit
  std::uint32_t placement = 0;  ///< placement of the face, first placement of the patch's step

  bool isPatch() const { return (code & kPatchBit) != 0; }
  std::uint32_t index() const { return code & ~kPatchBit; }
};

/// Crossed lattice edge from (i, j, k) towards +axis; i, j and the axis follow from where it is
/// kept.
struct MarkedEdge {
  float lowFraction = 0;   ///< position of the crossing seen first from the low end, in [0, 1]
  float highFraction = 0;  ///< ... from the high end
  std::uint32_t lowElement = 0, highElement = 0;
  std::uint16_t k = 0;
  std::uint16_t unused = 0;
};

/// Edges that start in lattice layer i. Edges of one axis stand by column j, then k; those of
/// column j are [columnStart[axis][j], columnStart[axis][j + 1]).
struct LayerEdges {
  std::array<std::vector<MarkedEdge>, 3> edges;
  std::array<std::vector<std::uint32_t>, 3> columnStart;
};

struct MarkedEdges {
  std::vector<LayerEdges> layers;      ///< by i
  std::vector<SweptElement> elements;  ///< what lowElement and highElement point to
};

}  // namespace swept
