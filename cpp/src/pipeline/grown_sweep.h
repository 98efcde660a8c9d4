// A swept volume grown by a distance, for a safety distance or a conservative envelope.
//
// In:    a cover of the swept volume (offset/cover.h).
// Out:   Hermite grids of the surface at any distance from the cover. The proof that a mesh made
//        from such a grid contains the swept volume. The findings for the report.
// Units: cells. Cost: see offset/.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "grid/hermite_grid.h"
#include "offset/containment.h"
#include "offset/settle.h"
#include "signs/cavities.h"
#include "swept/report.h"

namespace swept {

class GrownSweep {
 public:
  GrownSweep(offset::Cover cover, const GridPlan& grid)
      : cover_(std::move(cover)), tree_(cover_.triangles), grid_(grid) {}
  GrownSweep(const GrownSweep&) = delete;
  GrownSweep& operator=(const GrownSweep&) = delete;

  const offset::Cover& cover() const { return cover_; }
  /// Decides which lattice points lie outside. The SolidPoint argument returns true for points
  /// within the distance.
  using FindSigns = std::function<SignRuns(const MarkedEdges&, const SolidPoint&)>;
  HermiteGrid hermite(double distance, const FindSigns& findSigns, RunContext& run) const;
  /// Returns moves for those `vertices` whose distance from the cover is not `distance`
  /// (offset/settle.h).
  std::vector<VertexMove> settlingMoves(const TriMesh& mesh,
                                        const std::vector<std::int32_t>& vertices, double distance,
                                        RunContext& run) const {
    return offset::settlingMoves(mesh, vertices, tree_, distance, grid_, run);
  }
  offset::Containment prove(const TriMesh& mesh, double least, RunContext& run) const {
    return offset::proveContainment(cover_, tree_, mesh, grid_, least, run);
  }

  /// Findings for the report. `offset` and `bound` (largest distance of an envelope point from the
  /// grown volume): mm. `fromMesh`: the cover was made from an envelope.
  Finding offsetFinding(double offset, bool fromMesh) const;
  Finding conservativeFinding(const offset::Containment& proof, double offset, double bound) const;

 private:
  offset::Cover cover_;
  offset::CoverSearch tree_;
  const GridPlan& grid_;
};

}  // namespace swept
