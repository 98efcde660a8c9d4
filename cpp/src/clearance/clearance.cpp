// SPDX-License-Identifier: LGPL-2.1-or-later
#include "swept/clearance.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <string>

#include "base/limits.h"
#include "base/number_text.h"
#include "base/timer.h"
#include "clearance/guarded_report.h"
#include "clearance/pair_check.h"
#include "input/trajectory_check.h"
#include "motion/pivot.h"

namespace swept {
namespace {

using namespace clearance;

void requireOption(const char* name, double value, bool mayBeZero, const std::string& owner = "") {
  if (std::isfinite(value) && value >= 0 && value <= kLargestLength && (mayBeZero || value > 0))
    return;
  throw Error(Status::InvalidInput, "BadOption",
              owner + name + " is " + numberText(value, kTellingDigits) +
                  " mm; allowed: " + (mayBeZero ? "0" : "more than 0") + " up to 1e9 mm");
}

void checkClearanceOptions(const ClearanceOptions& o,
                           const std::vector<ClearanceNeighbour>& parts) {
  requireOption("required distance", o.required, true);
  requireOption("tolerance", o.tolerance, false);
  requireOption("chord error of the body", o.bodyChordError, true);
  requireOption("interval tolerance", o.intervalTolerance, true);
  if (o.curveSamples < 0 || o.curveSamples > 1000000)
    throw Error(Status::InvalidInput, "BadOption",
                "curve samples: " + std::to_string(o.curveSamples) + "; allowed: 0 to 1000000");
  if (parts.empty())
    throw Error(Status::InvalidInput, "NoNeighbours",
                "no neighbouring part given; choose at least one");
  for (const ClearanceNeighbour& part : parts)
    requireOption("chord error", part.chordError, true, "neighbour '" + part.name + "': ");
}

bool nearer(const NeighbourClearance& a, const NeighbourClearance& b) {
  if (a.distance - a.chordError != b.distance - b.chordError && (a.distance > 0 || b.distance > 0))
    return a.distance - a.chordError < b.distance - b.chordError;
  return a.penetration.depth > b.penetration.depth;
}

void summarise(ClearanceReport& report) {
  int clashes = 0;
  int contacts = 0;
  int below = 0;
  for (std::size_t i = 0; i < report.neighbours.size(); ++i) {
    const NeighbourClearance& row = report.neighbours[i];
    clashes += row.verdict == ClearanceVerdict::Clash;
    contacts += row.verdict == ClearanceVerdict::Contact;
    below += row.verdict == ClearanceVerdict::BelowRequired;
    if (report.smallest < 0 || nearer(row, report.neighbours[report.smallest]))
      report.smallest = static_cast<int>(i);
  }
  const NeighbourClearance& row = report.neighbours[report.smallest];
  report.summary = std::to_string(report.neighbours.size()) + " checked";
  const auto add = [&](int count, const char* what) {
    if (count > 0) report.summary += ", " + std::to_string(count) + " " + what;
  };
  add(clashes, clashes == 1 ? "clash" : "clashes");
  add(contacts, contacts == 1 ? "contact" : "contacts");
  add(below, "below required");
  const bool deep = row.verdict == ClearanceVerdict::Clash && row.penetration.known;
  const std::string length = numberText(deep ? row.penetration.depth : row.distance, 4);
  report.summary += (deep ? ", deepest " : ", smallest ") + length + " mm";
  const std::string certain = numberText(row.guaranteed, 4);
  if (!deep && certain != length) report.summary += ", at least " + certain + " mm,";
  report.summary += " at t = " + numberText(row.timeSeconds) + " s";
  if (!row.name.empty()) report.summary += " (" + row.name + ")";
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

const char* clearanceVerdictName(ClearanceVerdict verdict) {
  switch (verdict) {
    case ClearanceVerdict::Clear:
      return "clear";
    case ClearanceVerdict::BelowRequired:
      return "below";
    case ClearanceVerdict::Contact:
      return "contact";
    case ClearanceVerdict::Clash:
      return "clash";
  }
  return "?";
}

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
