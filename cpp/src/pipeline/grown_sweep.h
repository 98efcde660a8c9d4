// A swept volume grown by a length: safety distance, conservative envelope.
//
// In:    a cover of the swept volume (offset/). Out: Hermite grids at any distance from it,
//        the proof that a mesh made from one holds the swept volume, and what the report says.
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
  /// Which lattice points the outside reaches; those within the distance are solid.
  using FindSigns = std::function<SignRuns(const MarkedEdges&, const SolidPoint&)>;
  HermiteGrid hermite(double distance, const FindSigns& findSigns, RunContext& run) const;
  /// Which of some vertices of a surface made from such a grid are not at the distance.
  std::vector<VertexMove> settlingMoves(const TriMesh& mesh,
                                        const std::vector<std::int32_t>& vertices, double distance,
                                        RunContext& run) const {
    return offset::settlingMoves(mesh, vertices, tree_, distance, grid_, run);
  }
  offset::Containment prove(const TriMesh& mesh, double least, RunContext& run) const {
    return offset::proveContainment(cover_, tree_, mesh, grid_, least, run);
  }

  /// What the report says. `offset`, `bound` (how far outside a point may lie): mm. `fromMesh`: the
  /// cover is that of an envelope.
  Finding offsetFinding(double offset, bool fromMesh) const;
  Finding conservativeFinding(const offset::Containment& proof, double offset, double bound) const;

 private:
  offset::Cover cover_;
  offset::CoverSearch tree_;
  const GridPlan& grid_;
};

}  // namespace swept
