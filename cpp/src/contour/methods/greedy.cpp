// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>

#include "contour/methods/methods.h"

namespace swept {
namespace {

constexpr int kMaxComponents = kSlots / 2;  ///< the room that the caller has for components

/// The crossings at which a walk stops: the first on an edge with two, else the only one.
std::uint32_t slotsOf(std::uint32_t stops, std::uint32_t mask) {
  std::uint32_t slots = 0;
  for (int edge = 0; edge < kEdges; ++edge) {
    const std::uint32_t directions = stops >> (2 * edge) & 3u, has = mask >> (2 * edge) & 3u;
    if (directions == 0) continue;
    slots |= (has == 3 ? directions : has) << (2 * edge);
  }
  return slots;
}

/// The smallest cosine between two normals of the set.
float agreement(const Cell& cell, std::uint32_t slots, const Crossing* crossings) {
  float least = 1;
  for (int s = 0; s < kSlots; ++s) {
    if (!(slots >> s & 1u)) continue;
    const auto& n = crossings[cell.crossing(s)].normal;
    for (int t = s + 1; t < kSlots; ++t) {
      if (slots >> t & 1u) least = std::min(least, n.dot(crossings[cell.crossing(t)].normal));
    }
  }
  return least;
}

}  // namespace

void findGreedy(const Cell& cell, const Crossing* crossings, Components& out) {
  out.count = 0;
  out.of.fill(-1);
  std::uint32_t left = cell.mask;
  while (left != 0) {
    std::uint32_t crossed = 0;
    for (int edge = 0; edge < kEdges; ++edge) {
      if (left >> (2 * edge) & 3u) crossed |= 1u << edge;
    }
    const WalkTable::Entry& entry = walkTable().entries[crossed];
    std::uint32_t best = 0;
    float bestAgreement = -2;
    for (int k = 0; k < entry.count; ++k) {
      const std::uint32_t slots = slotsOf(entry.stops[k], left);
      if (slots == 0) continue;
      const float a = agreement(cell, slots, crossings);
      if (a > bestAgreement) {
        best = slots;
        bestAgreement = a;
      }
    }
    if (out.count == kMaxComponents - 1) best = left;
    for (int slot = 0; slot < kSlots; ++slot) {
      if (best >> slot & 1u) out.of[slot] = static_cast<std::int8_t>(out.count);
    }
    ++out.count;
    left &= ~best;
  }
}

}  // namespace swept
