// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pipeline/finish_surface.h"

#include <numeric>

#include "base/number_text.h"
#include "contour/mend/mend.h"
#include "contour/mend/move_vertices.h"
#include "contour/mend/rebuild.h"
#include "contour/mend/specks.h"
#include "contour/mend/surface_intersections.h"
#include "pipeline/require_passed.h"

namespace swept {
namespace {

/// Returns advice for details that are smaller than a cell (mm).
std::string smallerCell(double cell) {
  return textOf(3, "use a smaller cell, such as ", 0.5 * cell, " mm instead of ", cell, " mm,");
}

/// Returns where the first pair of intersecting triangles is, as the end of a sentence. Empty if
/// the report has no pair.
std::string firstIntersection(const TriMesh& mesh, const MeshCheck& check) {
  if (check.firstIntersections.empty()) return "";
  const auto& corners =
      mesh.triangles[static_cast<std::size_t>(check.firstIntersections.front().first)];
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const std::int32_t corner : corners)
    middle += mesh.vertices[static_cast<std::size_t>(corner)] / 3;
  return textOf(4, " (the first near x = ", middle.x(), ", y = ", middle.y(), ", z = ", middle.z(),
                " mm)");
}

/// Removes specks (contour/mend/specks.h). The sweep of a body in continuous motion is connected,
/// so no real part of it is as small as a speck. A union of separate copies may have such parts, so
/// only parts without volume are removed then.
void dropSpecks(Surface& surface, SelfIntersections& pairs, const Finishing& with, Report& report) {
  if (with.options.conservative) return;
  const double cell = with.prepared.grid.cell;
  const double most = with.prepared.motion.continuous ? kSpeckVolume : kFlatVolume;
  const Specks specks = swept::dropSpecks(surface, cell, most, pairs, with.run);
  if (specks.count == 0) return;
  report.warnings.push_back(
      {"SpecksDropped",
       specks.count,
       {},
       textOf(3, counted(specks.count, "separate piece that is", "separate pieces that are"),
              " too small for the cells of the grid ", specks.count == 1 ? "was" : "were",
              " removed beside the envelope; the largest is ", specks.largestSize * cell,
              " mm across and has a volume of ", specks.largestVolume * cell * cell * cell,
              " mm^3; ", smallerCell(cell), " if they matter")});
}

bool turnInsideOut(Surface& surface, const MeshTopology& topology, const Finishing& with,
                   Report& report) {
  if (!report.check.closed || report.check.misorientedEdges > 0) return false;
  const std::int64_t count =
      swept::turnInsideOut(surface, topology, with.prepared.grid.cell, with.run);
  if (count == 0) return false;
  report.warnings.push_back({"ShellsTurned",
                             count,
                             {},
                             counted(count, "very thin shell", "very thin shells") +
                                 ", a few cells across, faced inwards and " +
                                 (count == 1 ? "was" : "were") + " reversed; " +
                                 smallerCell(with.prepared.grid.cell) + " if such details matter"});
  return true;
}

void mend(Surface& surface, const HermiteGrid& hermite, SelfIntersections& pairs,
          const Finishing& with, Report& report) {
  const std::int64_t before = pairs.count;
  pairs = mendSelfIntersections(surface, hermite, pairs, with.run);
  if (pairs.count > 0) pairs = rebuildCells(surface, hermite, pairs, with.run);
  report.warnings.push_back({"Mended",
                             before - pairs.count,
                             {},
                             counted(before, "pair", "pairs") +
                                 " of triangles intersected before repair; after it, " +
                                 counted(pairs.count, "pair intersects", "pairs intersect")});
  with.stage("mend");
}

/// Repairs and checks a surface with consistent components.
MeshTopology mendAll(Surface& surface, const HermiteGrid& hermite, const Finishing& with,
                     Report& report) {
  MeshTopology topology;
  if (with.settlingMoves) {
    std::vector<std::int32_t> all(surface.mesh.vertices.size());
    std::iota(all.begin(), all.end(), 0);
    for (const VertexMove& move : with.settlingMoves(surface.mesh, all))
      surface.mesh.vertices[move.vertex] = move.position;
    with.stage("settle");
  }
  SelfIntersections pairs = findSurfaceIntersections(surface, hermite, with.run);
  with.stage("intersections");
  if (pairs.count > 0) mend(surface, hermite, pairs, with, report);
  if (with.settlingMoves && pairs.count == 0) {
    moveWithoutPairs(surface, hermite.plan, with.settlingMoves(surface.mesh, surface.mended),
                     with.run);
  }
  dropSpecks(surface, pairs, with, report);
  report.check = checkMesh(surface.mesh, topology, with.run);
  if (!report.check.oriented && turnInsideOut(surface, topology, with, report)) {
    report.check = checkMesh(surface.mesh, topology, with.run);
  }
  report.check.selfIntersections = pairs.count;
  for (const auto& pair : pairs.pairs) {
    if (report.check.firstIntersections.size() == 32) break;
    report.check.firstIntersections.emplace_back(pair.first, pair.second);
  }
  return topology;
}

}  // namespace

MeshTopology checkAndMend(Surface& surface, const HermiteGrid& hermite, const Finishing& with,
                          Report& report) {
  const bool consistent = with.options.components == ComponentMethod::Consistent;
  MeshTopology topology;
  if (consistent) {
    topology = mendAll(surface, hermite, with, report);
  } else {
    SelfIntersections pairs;
    report.check = checkMesh(surface.mesh, pairs, with.run);
  }
  with.stage("check");
  if (const std::int64_t pairs = report.check.selfIntersections.value_or(0); pairs > 0) {
    report.warnings.push_back(
        {"SelfIntersections",
         pairs,
         {},
         counted(pairs, "pair of triangles intersects", "pairs of triangles intersect") +
             firstIntersection(surface.mesh, report.check) +
             textOf(3, "; a smaller cell usually avoids this: try ", 0.9 * report.cellSize,
                    " mm instead of ", report.cellSize, " mm")});
  }
  if (consistent) requirePassed(report.check, "the envelope", report.cellSize);
  return topology;
}

}  // namespace swept
