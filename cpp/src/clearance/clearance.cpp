// SPDX-License-Identifier: LGPL-2.1-or-later
#include "swept/clearance.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <string>

#include "base/timer.h"
#include "clearance/guarded_report.h"
#include "clearance/options_check.h"
#include "clearance/pair_check.h"
#include "clearance/summary.h"
#include "input/trajectory_check.h"
#include "motion/pivot.h"

namespace swept {
namespace {

using namespace clearance;

void checkClearanceOptions(const ClearanceOptions& o,
                           const std::vector<ClearanceNeighbour>& parts) {
  checkSettings(o);
  if (parts.empty())
    throw Error(Status::InvalidInput, "NoNeighbours",
                "no neighbouring part given; choose at least one");
  for (const ClearanceNeighbour& part : parts)
    requireLength("neighbour '" + part.name + "': chord error", part.chordError, true);
}

void summarise(ClearanceReport& report) {
  std::vector<const NeighbourClearance*> rows;
  for (const NeighbourClearance& row : report.neighbours) rows.push_back(&row);
  const Summary summary = summaryOf(rows, std::to_string(rows.size()) + " checked");
  report.smallest = summary.smallest;
  report.summary = summary.text;
}

void runCheck(ClearanceReport& report, const TriMesh& body, const Trajectory& trajectory,
              const std::vector<ClearanceNeighbour>& neighbours, const ClearanceOptions& options,
              RunContext& run) {
  Timer timer;
  run.checkpoint(Phase::Input);
  checkClearanceOptions(options, neighbours);
  const Eigen::Vector3d pivot = pivotOf(trajectory);
  CheckedTrajectory checked = checkTrajectory(trajectory);
  report.warnings = std::move(checked.findings);
  bool mended = false;
  const Part moving = closedPart(seenFromPivot(body, pivot), "the moving body", run, mended);
  report.bodyTriangles = std::ssize(body.triangles);
  for (const ClearanceNeighbour& part : neighbours)
    report.neighbourTriangles += std::ssize(part.mesh.triangles);
  run.checkpoint(Phase::Motion);
  const Box box = moving.box(moving.tree().root());
  const MotionTree motion(carriedByPivot(checked.trajectory, pivot), box.centre, box.half);
  report.placements = std::ssize(checked.trajectory.poses);
  report.seconds.push_back({"prepare", timer.lap()});
  report.neighbours.resize(neighbours.size());
  std::atomic<std::uint64_t> done{0};
  tbb::parallel_for(std::size_t{0}, neighbours.size(), [&](std::size_t i) {
    bool neighbourMended = false;
    const Part still = closedPart(neighbours[i].mesh, "neighbour '" + neighbours[i].name + "'", run,
                                  neighbourMended);
    const CheckedPair pair{moving, mended, still, neighbourMended};
    NeighbourClearance& row = report.neighbours[i];
    row = checkPair(pair, neighbours[i].name, neighbours[i].chordError, motion, options, run);
    row.pose = backFromPivot(row.pose, pivot);
    row.penetration.pose = backFromPivot(row.penetration.pose, pivot);
    run.checkpoint(Phase::Check, ++done, neighbours.size());
  });
  std::vector<std::string> names;
  std::vector<char> closed;
  for (const NeighbourClearance& row : report.neighbours) {
    names.push_back(row.name);
    closed.push_back(row.closed ? 1 : 0);
  }
  for (const Finding& finding : openFindings(names, closed, moving.closed()))
    report.warnings.push_back(finding);
  summarise(report);
  report.seconds.push_back({"search", timer.lap()});
  report.seconds.push_back({"total", timer.seconds()});
  run.checkpoint(Phase::Done);
}

void takeBack(ClearanceReport& report) {
  report.neighbours.clear();
  report.smallest = -1;
  report.summary.clear();
}

}  // namespace

ClearanceReport checkClearance(const TriMesh& body, const Trajectory& trajectory,
                               const std::vector<ClearanceNeighbour>& neighbours,
                               const ClearanceOptions& options, RunContext& run) {
  ClearanceReport report;
  report.required = options.required;
  report.tolerance = options.tolerance;
  report.interpolation = interpolationName(trajectory.interpolation);
  fillGuarded(report, run, "clearance check", "parts and motion", takeBack,
              [&] { runCheck(report, body, trajectory, neighbours, options, run); });
  return report;
}

std::vector<double> distanceToMesh(const std::vector<Eigen::Vector3d>& points, const TriMesh& mesh,
                                   RunContext& run) {
  const Part part(mesh, "the mesh");
  std::vector<double> distances(points.size());
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, points.size(), 1024),
      [&](const tbb::blocked_range<std::size_t>& range) {
        run.checkpoint(Phase::Check);
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
          const double d =
              part.nearest(points[i], std::numeric_limits<double>::infinity()).distance;
          distances[i] = part.inside(points[i]) ? -d : d;
        }
      });
  return distances;
}

}  // namespace swept
