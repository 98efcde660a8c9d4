// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/mend/cell_rings.h"

#include <algorithm>

namespace swept {
namespace {

/// Least distance (cells) of crossings from each other and from the ends of their edge. It is far
/// above rounding, but too small to be visible.
constexpr double kApart = 1e-4;

/// Returns the face along which a ring leaves a slot. The triangles of the slot's polygon run round
/// the edge of the slot, counter-clockwise seen from the outside end (surface.cpp).
int faceBehind(int slot) {
  const int edge = slot >> 1, axis = edge >> 2;
  const bool seenFromLow = (slot & 1) == 0;
  const int side = seenFromLow ? quadCorner(edge) : (quadCorner(edge) + 3) & 3;
  const int b = 2 * ((axis + 1) % 3) + (edge & 1), c = 2 * ((axis + 2) % 3) + (edge >> 1 & 1);
  return quadSide(edge, b) == side ? b : c;
}

}  // namespace

std::vector<CellRing> ringsOf(const Cell& cell, const Crossing* crossings) {
  std::array<std::array<std::int8_t, kSlots>, kFaces> partner;
  for (int face = 0; face < kFaces; ++face) {
    const FacePairs pairs = pairFace(cell, face, crossings);
    for (int p = 0; p < pairs.count; ++p) {
      const auto [x, y] = pairs.slots[p];
      partner[face][x] = y;
      partner[face][y] = x;
    }
  }
  std::vector<CellRing> rings;
  std::uint32_t left = cell.mask;
  for (int slot = 0; slot < kSlots; ++slot) {
    if ((left >> slot & 1u) == 0) continue;
    CellRing ring;
    for (int at = slot; (left >> at & 1u) != 0;) {
      left &= ~(1u << at);
      const int face = faceBehind(at);
      ring.slots.push_back(static_cast<std::int8_t>(at));
      ring.faces.push_back(static_cast<std::int8_t>(face));
      at = partner[face][at];
    }
    rings.push_back(std::move(ring));
  }
  return rings;
}

double apartFraction(const Cell& cell, int slot, const Crossing* crossings) {
  const double own = crossings[cell.crossing(slot)].fraction;
  if (!cell.has(slot ^ 1)) return std::clamp(own, kApart, 1 - kApart);
  const double other = crossings[cell.crossing(slot ^ 1)].fraction;
  const bool low = (slot & 1) == 0;
  const double from = low ? own : other, to = low ? other : own;
  if (to - from >= kApart)
    return low ? std::clamp(own, kApart, 1 - 2 * kApart) : std::clamp(own, 2 * kApart, 1 - kApart);
  const double middle = std::clamp((from + to) / 2, 1.5 * kApart, 1 - 1.5 * kApart);
  return middle + (low ? -0.5 : 0.5) * kApart;
}

Eigen::Vector3d apartPosition(const Cell& cell, int slot, const Crossing* crossings) {
  Eigen::Vector3d p = localPosition(slot >> 1, 0);
  p[slot >> 3] = apartFraction(cell, slot, crossings);
  return p;
}

Eigen::Vector3d chordPoint(const Cell& cell, int face, int from, int to,
                           const Crossing* crossings) {
  const Eigen::Vector3d p = apartPosition(cell, from, crossings),
                        q = apartPosition(cell, to, crossings);
  Eigen::Vector3d middle = (p + q) / 2;
  if (from >> 1 != to >> 1) return middle;
  // `across`: the axis of the face at right angles to the edge. `gap`: distance to the nearest
  // other chord.
  const int edge = from >> 1, across = 3 - (edge >> 2) - (face >> 1);
  double gap = (q - p).cwiseAbs().maxCoeff();
  for (const FaceStep& step : kFaceWalks[face]) {
    if (step.edge == edge) continue;
    for (const int slot : {2 * step.edge, 2 * step.edge + 1}) {
      if (!cell.has(slot)) continue;
      gap = std::min(gap, std::abs(apartPosition(cell, slot, crossings)[across] - p[across]));
    }
  }
  middle[across] += (p[across] < 0.5 ? 0.25 : -0.25) * gap;
  return middle;
}

}  // namespace swept
