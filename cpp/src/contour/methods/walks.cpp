// SPDX-License-Identifier: LGPL-2.1-or-later
#include <memory>

#include "contour/methods/methods.h"

namespace swept {
namespace {

WalkTable::Entry walk(std::uint32_t crossed) {
  WalkTable::Entry entry;
  std::uint32_t unvisited = 0xff;
  for (int start = 0; start < 8; ++start) {
    if (!(unvisited >> start & 1u)) continue;
    // Grow the set of reached corners until nothing changes.
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

}  // namespace

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
    // A walk that starts outside leaves from the end that its crossing is seen from.
    const std::uint32_t mine = entry.stops[group] & cell.mask;
    if (mine == 0) continue;
    for (int slot = 0; slot < kSlots; ++slot) {
      if (mine >> slot & 1u) out.of[slot] = static_cast<std::int8_t>(out.count);
    }
    ++out.count;
  }
}

}  // namespace swept
