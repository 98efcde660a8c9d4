// A leaf cell (a cell with crossings), and the numbering of its corners, edges, slots and faces.
//
// Edge number a * 4 + ob + 2 * oc runs along axis a. Let b = a + 1 and c = a + 2 (mod 3) be the
// other axes. ob tells whether the edge lies on the low (0) or the high (1) side of the cell along
// b, oc the same along c.
// Slot number edge * 2 + side holds the crossing that is "seen" from the low (0) or high (1) end of
// the edge: the first crossing on the edge, starting at this end. The slot is empty unless this end
// lies outside.
// Face number a * 2 + s is perpendicular to axis a, at the low (s = 0) or high (s = 1) side of the
// cell.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "grid/hermite_grid.h"

namespace swept {

constexpr int kEdges = 12, kSlots = 24, kFaces = 6;

/// Vertices stay this far from the walls of their cell (fraction of the cell), so that the vertices
/// of two neighbouring cells never coincide. The margin is a thousand times the rounding of the
/// 32-bit local positions, but too small to be visible.
constexpr double kCellMargin = 1e-4;

constexpr int edgeOf(int axis, int ob, int oc) { return axis * 4 + ob + 2 * oc; }

struct Cell {
  std::uint32_t mask = 0;  ///< one bit per slot, set if the slot holds a crossing
  std::uint16_t k = 0;     ///< index of the cell along z; i and j are those of its column
  /// Per edge: index of the crossing in the lowest filled slot of the edge.
  std::array<std::uint32_t, kEdges> first;

  bool has(int slot) const { return (mask >> slot & 1u) != 0; }
  std::uint32_t crossing(int slot) const {
    const bool second = (slot & 1) && has(slot - 1);
    return first[slot >> 1] + (second ? 1 : 0);
  }
};

/// One step of a walk round a face: an edge, and whether the walk follows the edge from its high
/// end to its low end.
struct FaceStep {
  std::int8_t edge;
  bool backward;
};

/// The four edges of each face in the order of a walk round the face.
constexpr std::array<std::array<FaceStep, 4>, kFaces> makeFaceWalks() {
  std::array<std::array<FaceStep, 4>, kFaces> walks{};
  for (int a = 0; a < 3; ++a) {
    for (int s = 0; s < 2; ++s) {
      // b and c are the axes of the face. An edge along b is numbered by its sides along (c, a), an
      // edge along c by its sides along (a, b).
      const int b = (a + 1) % 3, c = (a + 2) % 3;
      auto& walk = walks[a * 2 + s];
      walk[0] = {static_cast<std::int8_t>(edgeOf(b, 0, s)), false};
      walk[1] = {static_cast<std::int8_t>(edgeOf(c, s, 1)), false};
      walk[2] = {static_cast<std::int8_t>(edgeOf(b, 1, s)), true};
      walk[3] = {static_cast<std::int8_t>(edgeOf(c, s, 0)), true};
    }
  }
  return walks;
}
inline constexpr auto kFaceWalks = makeFaceWalks();

/// Returns the position of a crossing in the coordinates of its cell, [0, 1]^3.
inline Eigen::Vector3d localPosition(int edge, float fraction) {
  const int a = edge >> 2;
  Eigen::Vector3d p;
  p[a] = fraction;
  p[(a + 1) % 3] = edge & 1;
  p[(a + 2) % 3] = edge >> 1 & 1;
  return p;
}

/// Returns the number (x + 2 y + 4 z) of the corner at the low (0) or high (1) end of an edge.
constexpr int cornerOf(int edge, int end) {
  const int a = edge >> 2, b = (a + 1) % 3, c = (a + 2) % 3;
  return end << a | (edge & 1) << b | (edge >> 1 & 1) << c;
}

/// Four cells surround a lattice edge along axis a. Their vertices are the corners of the quad of
/// this edge. Returns the corner that belongs to the cell in which the lattice edge has number
/// `edge`. Corners are counted counter-clockwise about +a, starting with the cell at (-b, -c).
constexpr int quadCorner(int edge) {
  const int ob = edge & 1, oc = edge >> 1 & 1;
  return oc == 1 ? (ob == 1 ? 0 : 1) : (ob == 1 ? 3 : 2);
}

/// Returns which side of the quad passes through the given face of the cell. Side n joins the
/// corners n and n + 1 (quadCorner()).
constexpr int quadSide(int edge, int face) {
  const int a = edge >> 2, b = (a + 1) % 3;
  const int ob = edge & 1, oc = edge >> 1 & 1;
  return (face >> 1) == b ? (oc == 1 ? 0 : 2) : (ob == 1 ? 3 : 1);
}

}  // namespace swept
