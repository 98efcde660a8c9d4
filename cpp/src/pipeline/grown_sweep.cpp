// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pipeline/grown_sweep.h"

#include "sampling/hermite.h"
#include "sampling/offset/offset_surface.h"
#include "sampling/signs.h"

namespace swept {

HermiteGrid GrownSweep::hermite(double distance, RunContext& run) const {
  const offset::OffsetField field(tree_, distance, grid_, run);
  const MarkedEdges marked = offset::markOffset(field, tree_, grid_, run);
  const SignRuns signs = findOutside(marked, grid_, run);
  return buildHermiteGrid(
      grid_, marked, signs,
      [&](int axis, std::int32_t i, std::int32_t j, const MarkedEdge& edge, bool fromLow) {
        return offset::offsetCrossing(tree_, distance, axis, i, j, edge, fromLow);
      },
      run);
}

}  // namespace swept
