// Does what all computations of a path have in common: fills the general entries of the report, and
// turns errors into its status.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <iterator>
#include <vector>

#include "clearance/guarded_report.h"
#include "swept/path.h"

namespace swept::path {

/// Calls work(report, neighbours) with the neighbours that are not ignored. work() fills the report
/// and returns the seconds that it took; it may throw.
template <class Work>
PathReport guardedPath(const TriMesh& part, const std::vector<ClearanceNeighbour>& neighbours,
                       const PathOptions& options, RunContext& run, const Work& work) {
  PathReport report;
  report.required = options.clearance;
  report.tolerance = options.tolerance;
  report.release = options.release;
  report.seed = options.seed;
  report.interpolation = interpolationName(options.interpolation);
  report.bodyTriangles = std::ssize(part.triangles);
  for (const ClearanceNeighbour& n : neighbours)
    report.neighbourTriangles += std::ssize(n.mesh.triangles);
  std::vector<ClearanceNeighbour> some;
  for (const ClearanceNeighbour& n : neighbours)
    if (n.rule.ignored) report.ignored.push_back(n.name);
  if (!report.ignored.empty())
    std::copy_if(neighbours.begin(), neighbours.end(), std::back_inserter(some),
                 [](const ClearanceNeighbour& n) { return !n.rule.ignored; });
  const auto removeResults = clearance::keepOnlyThreads<PathReport>;
  clearance::fillGuarded(report, run, "search", "the parts", removeResults, [&] {
    run.checkpoint(Phase::Input);
    for (const ClearanceNeighbour& n : neighbours)
      checkRule(n.rule, "the rule of neighbour '" + n.name + "'");
    const double seconds = work(report, report.ignored.empty() ? neighbours : some);
    report.seconds.push_back({"total", seconds});
    run.checkpoint(Phase::Done);
  });
  return report;
}

}  // namespace swept::path
