// What every run that ends in a path does: the head of its report, the wall round it.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "clearance/guarded_report.h"
#include "swept/path.h"

namespace swept::path {

/// work(report) fills the report and gives the seconds that it took; it may throw.
template <class Work>
PathReport guardedPath(const TriMesh& part, const std::vector<PathNeighbour>& neighbours,
                       const PathOptions& options, RunContext& run, const Work& work) {
  PathReport report;
  report.required = options.clearance;
  report.tolerance = options.tolerance;
  report.release = options.release;
  report.seed = options.seed;
  report.interpolation = interpolationName(options.interpolation);
  report.bodyTriangles = std::ssize(part.triangles);
  for (const PathNeighbour& n : neighbours)
    report.neighbourTriangles += std::ssize(n.part.mesh.triangles);
  const auto takeBack = [](PathReport& taken) {
    const int threads = taken.threads;
    taken = {};
    taken.threads = threads;
  };
  clearance::fillGuarded(report, run, "search", "the parts", takeBack, [&] {
    run.checkpoint(Phase::Input);
    const double seconds = work(report);
    report.seconds.push_back({"total", seconds});
    run.checkpoint(Phase::Done);
  });
  return report;
}

}  // namespace swept::path
