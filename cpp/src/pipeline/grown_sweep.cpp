// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pipeline/grown_sweep.h"

#include "base/number_text.h"
#include "crossings/hermite.h"
#include "offset/offset_surface.h"

namespace swept {

HermiteGrid GrownSweep::hermite(double distance, const FindSigns& findSigns,
                                RunContext& run) const {
  const offset::OffsetField field(tree_, distance, grid_, run);
  const MarkedEdges marked = offset::markOffset(field, tree_, grid_, run);
  const SignRuns signs = findSigns(marked, [&](std::int32_t i, std::int32_t j, std::int32_t k) {
    return field.gap(i, j, k) <= 0;
  });
  return buildHermiteGrid(
      grid_, marked, signs, ExactTimes::Dropped,
      [&](int axis, std::int32_t i, std::int32_t j, const MarkedEdge& edge, bool fromLow, double*) {
        return offset::offsetCrossing(tree_, distance, axis, i, j, edge, fromLow);
      },
      run);
}

Finding GrownSweep::offsetFinding(double offset, bool fromMesh) const {
  std::string text = textOf(4, "the envelope was grown by ", offset, " mm");
  if (fromMesh) {
    text += textOf(4,
                   "; the distance was measured from the mesh of the envelope before it was "
                   "grown (",
                   cover_.triangles.size(),
                   " triangles). The deviation of this mesh "
                   "adds to that of the result");
  } else {
    text +=
        textOf(4, "; the distance is accurate to ",
               (cover_.largestSlack + cover_.chord) * grid_.cell, " mm (it is measured from ",
               cover_.triangles.size(), " triangles that cover the boundary of the swept volume)");
  }
  return {"Offset", static_cast<std::int64_t>(cover_.triangles.size()), {}, std::move(text)};
}

Finding GrownSweep::conservativeFinding(const offset::Containment& proof, double offset,
                                        double bound) const {
  const double cell = grid_.cell;
  std::string text = "the envelope contains the swept volume";
  if (offset > 0) text += textOf(4, " grown by ", offset, " mm");
  text +=
      textOf(4, ": every point of the envelope is at least ", proof.nearest * cell,
             " mm away from the computed motion of the part, and the true motion deviates from the "
             "computed motion by at most ",
             cover_.chord * cell, " mm; no point of the envelope lies more than ", bound,
             " mm outside the volume that it must contain");
  return {"Conservative", static_cast<std::int64_t>(cover_.triangles.size()), {}, std::move(text)};
}

}  // namespace swept
