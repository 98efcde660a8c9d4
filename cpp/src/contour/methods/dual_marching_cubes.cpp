// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/methods/methods.h"

namespace swept {

void findDualMarchingCubes(const Cell& cell, Components& out) {
  SlotLinks links;
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
      if (enters[i]) links.join(stops[i], stops[(i + 1) % n]);
    }
  }
  links.setComponents(out);
}

}  // namespace swept
