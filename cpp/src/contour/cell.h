// One leaf cell: its crossings, and the numbering of corners, edges and faces.
//
// Edge a * 4 + ob + 2 * oc runs along axis a; ob, oc (0 or 1) place it along the next axes b = a +
// 1 and c = a + 2 (mod 3). Slot edge * 2 + side holds the crossing seen from the low (0) or high
// (1) end. Face a * 2 + s is perpendicular to axis a at side s.
//
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "grid/hermite_grid.h"

namespace swept {

constexpr int kEdges = 12, kSlots = 24, kFaces = 6;

/// Vertices keep this far from their cell's walls, so that those of neighbours never coincide.
constexpr double kCellMargin = 1e-4;

constexpr int edgeOf(int axis, int ob, int oc) { return axis * 4 + ob + 2 * oc; }

struct Cell {
  std::uint32_t mask = 0;  ///< bit per slot that holds a crossing
  std::uint16_t k = 0;
  std::array<std::uint32_t, kEdges> first;  ///< crossing of the edge's lowest filled slot

  bool has(int slot) const { return (mask >> slot & 1u) != 0; }
  std::uint32_t crossing(int slot) const {
    const bool second = (slot & 1) && has(slot - 1);
    return first[slot >> 1] + (second ? 1 : 0);
  }
};

/// A step of the walk round a face: an edge, and whether it is passed from its high end to its low.
struct FaceStep {
  std::int8_t edge;
  bool backward;
};

/// The four edges of each face in order, going round.
constexpr std::array<std::array<FaceStep, 4>, kFaces> makeFaceWalks() {
  std::array<std::array<FaceStep, 4>, kFaces> walks{};
  for (int a = 0; a < 3; ++a) {
    for (int s = 0; s < 2; ++s) {
      // Axes b, c of the face. Edge along b lies at (c, a), edge along c at (a, b).
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

/// Crossing position in the cell's own coordinates, [0, 1]^3.
inline Eigen::Vector3d localPosition(int edge, float fraction) {
  const int a = edge >> 2;
  Eigen::Vector3d p;
  p[a] = fraction;
  p[(a + 1) % 3] = edge & 1;
  p[(a + 2) % 3] = edge >> 1 & 1;
  return p;
}

/// Which of the four cells round a lattice edge of axis a sees it as (ob, oc): counted
/// counter-clockwise about +a from the cell at (-b, -c).
constexpr int quadCorner(int edge) {
  const int ob = edge & 1, oc = edge >> 1 & 1;
  return oc == 1 ? (ob == 1 ? 0 : 1) : (ob == 1 ? 3 : 2);
}

/// Side of that quad (between corners n and n + 1) that passes through the given face of the cell.
constexpr int quadSide(int edge, int face) {
  const int a = edge >> 2, b = (a + 1) % 3;
  const int ob = edge & 1, oc = edge >> 1 & 1;
  return (face >> 1) == b ? (oc == 1 ? 0 : 2) : (ob == 1 ? 3 : 1);
}

}  // namespace swept
