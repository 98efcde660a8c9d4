// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/methods/methods.h"

namespace swept {

void findDualMarchingCubes(const Cell& cell, Components& out) {
  out.count = 0;
  out.of.fill(-1);
  std::array<std::array<std::int8_t, 2>, kSlots> link;
  std::array<std::int8_t, kSlots> links{};
  for (int face = 0; face < kFaces; ++face) {
    // Going round the face, each crossing that enters the inside is joined to the next one, which
    // leaves it.
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
      if (!enters[i]) continue;
      const std::int8_t p = stops[i], q = stops[(i + 1) % n];
      link[p][links[p]++] = q;
      link[q][links[q]++] = p;
    }
  }
  for (int slot = 0; slot < kSlots; ++slot) {
    if (links[slot] == 0 || out.of[slot] >= 0) continue;
    int at = slot, from = -1;
    do {
      out.of[at] = static_cast<std::int8_t>(out.count);
      const int next = link[at][0] != from ? link[at][0] : link[at][1];
      from = at;
      at = next;
    } while (out.of[at] < 0);
    ++out.count;
  }
}

}  // namespace swept
