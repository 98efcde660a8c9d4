// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pipeline/grown_sweep.h"

#include "sampling/hermite.h"
#include "sampling/offset/offset_surface.h"

namespace swept {

HermiteGrid GrownSweep::hermite(double distance, const FindSigns& findSigns,
                                RunContext& run) const {
  const offset::OffsetField field(tree_, distance, grid_, run);
  const MarkedEdges marked = offset::markOffset(field, tree_, grid_, run);
  const SignRuns signs = findSigns(marked, [&](std::int32_t i, std::int32_t j, std::int32_t k) {
    return field.gap(i, j, k) <= 0;
  });
  return buildHermiteGrid(
      grid_, marked, signs,
      [&](int axis, std::int32_t i, std::int32_t j, const MarkedEdge& edge, bool fromLow) {
        return offset::offsetCrossing(tree_, distance, axis, i, j, edge, fromLow);
      },
      run);
}

}  // namespace swept
