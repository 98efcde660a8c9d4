// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/methods/methods.h"

#include <algorithm>
#include <memory>

namespace swept {
namespace {

WalkTable::Entry walk(std::uint32_t crossed) {
  WalkTable::Entry entry;
  std::uint32_t unvisited = 0xff;
  for (int start = 0; start < 8; ++start) {
    if (!(unvisited >> start & 1u)) continue;
    // Grow the set of reached corners until it no longer changes.
    std::uint32_t reached = 1u << start, before = 0;
    while (reached != before) {
      before = reached;
      for (int edge = 0; edge < kEdges; ++edge) {
        if (crossed >> edge & 1u) continue;
        const std::uint32_t ends = 1u << cornerOf(edge, 0) | 1u << cornerOf(edge, 1);
        if (reached & ends) reached |= ends;
      }
    }
    unvisited &= ~reached;
    std::uint32_t stops = 0;
    for (int edge = 0; edge < kEdges; ++edge) {
      if (!(crossed >> edge & 1u)) continue;
      for (int end = 0; end < 2; ++end) {
        if (reached >> cornerOf(edge, end) & 1u) stops |= 1u << (2 * edge + end);
      }
    }
    entry.stops[entry.count++] = stops;
  }
  return entry;
}

constexpr int kMaxComponents = kSlots / 2;  ///< the result has room for this many components

/// Returns the slots at which a walk stops. `stops` has one bit per edge and direction (WalkTable).
/// On an edge with two crossings, the walk stops at the first crossing in its direction.
std::uint32_t slotsOf(std::uint32_t stops, std::uint32_t mask) {
  std::uint32_t slots = 0;
  for (int edge = 0; edge < kEdges; ++edge) {
    const std::uint32_t directions = stops >> (2 * edge) & 3u, has = mask >> (2 * edge) & 3u;
    if (directions == 0) continue;
    slots |= (has == 3 ? directions : has) << (2 * edge);
  }
  return slots;
}

/// Returns the smallest cosine between the normals of two crossings in these slots.
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

void findDualMarchingCubes(const Cell& cell, Components& out) {
  SlotLinks links;
  for (int face = 0; face < kFaces; ++face) {
    // On a walk round the face, join each crossing that enters the inside to the next crossing,
    // which leaves the inside.
    std::int8_t stops[4];
    bool enters[4];
    int n = 0;
    for (const FaceStep& step : kFaceWalks[face]) {
      const std::uint32_t sides = cell.mask >> (2 * step.edge) & 3u;
      if (sides != 1 && sides != 2) continue;
      const bool fromLow = sides == 1;
      stops[n] = static_cast<std::int8_t>(2 * step.edge + (fromLow ? 0 : 1));
      enters[n++] = fromLow != step.backward;
    }
    for (int i = 0; i < n; ++i) {
      if (enters[i]) links.join(stops[i], stops[(i + 1) % n]);
    }
  }
  links.setComponents(out);
}

const WalkTable& walkTable() {
  static const std::unique_ptr<const WalkTable> table = [] {
    auto made = std::make_unique<WalkTable>();
    for (std::uint32_t crossed = 0; crossed < 4096; ++crossed)
      made->entries[crossed] = walk(crossed);
    return made;
  }();
  return *table;
}

void findEquivalence(const Cell& cell, Components& out) {
  std::uint32_t crossed = 0;
  for (int edge = 0; edge < kEdges; ++edge) {
    if (cell.mask >> (2 * edge) & 3u) crossed |= 1u << edge;
  }
  out.count = 0;
  out.of.fill(-1);
  const WalkTable::Entry& entry = walkTable().entries[crossed];
  for (int group = 0; group < entry.count; ++group) {
    // A walk from an outside corner stops at the crossings that are seen from this corner.
    const std::uint32_t seen = entry.stops[group] & cell.mask;
    if (seen == 0) continue;
    for (int slot = 0; slot < kSlots; ++slot) {
      if (seen >> slot & 1u) out.of[slot] = static_cast<std::int8_t>(out.count);
    }
    ++out.count;
  }
}

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
