// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pipeline/kept_surface.h"

#include "check/mesh_check.h"
#include "check/self_intersections.h"
#include "pipeline/require_passed.h"
#include "simplify/simplify.h"

namespace swept {

void cutKept(Result& result, double tolerance, RunContext& run) {
  const SimplifyTree& kept = *result.kept;
  Report& report = result.report;
  if (tolerance > 0) {
    Simplified cut = kept.cut(
        tolerance, [&](const TriMesh& m) { return findSelfIntersections(m, {}, run).pairs; }, run);
    result.mesh = std::move(cut.mesh);
    result.contactTime = std::move(cut.contactTime);
    result.featureEdges = std::move(cut.featureEdges);
    report.simplificationDeviation = cut.deviation;
  } else {
    result.mesh = kept.mesh();
    result.contactTime = kept.contactTime();
    result.featureEdges = kept.featureEdges();
    report.simplificationDeviation = 0;
  }
  report.check = checkMesh(result.mesh, run);
  requirePassed(report.check, "the simplified envelope", report.cellSize);
}

}  // namespace swept
