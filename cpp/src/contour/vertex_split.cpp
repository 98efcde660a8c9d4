// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/vertex_split.h"

#include <algorithm>

namespace swept {

void VertexSplit::findFolds(const Cell& cell, const Components& components, int component,
                            const Crossing* crossings) {
  folds.clear();
  foldFaces.clear();
  for (int slot = 0; slot < kSlots; ++slot) {
    if (components.of[slot] == component && part[slot] < 0) return;
  }
  bool ambiguous = false;
  for (int face = 0; face < kFaces; ++face) {
    const FacePairs pairs = pairFace(cell, face, crossings);
    for (int p = 0; p < pairs.count; ++p) {
      const auto [x, y] = pairs.slots[p];
      if (components.of[x] != component || part[x] == part[y]) continue;
      folds.push_back(pairs.slots[p]);
      foldFaces.push_back(static_cast<std::int8_t>(face));
      ambiguous |= pairs.count > 1;  // joined otherwise, see surface.h
    }
  }
  if (folds.size() == 2 && !ambiguous) return;
  folds.clear();
  foldFaces.clear();
}

}  // namespace swept
