// SPDX-License-Identifier: LGPL-2.1-or-later
#include "swept/clearance.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <string>

#include "base/number_text.h"
#include "base/parallel.h"
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
    throw Error(Status::InvalidInput, "NoNeighbours", "no neighbour is given; choose at least one");
  for (const ClearanceNeighbour& part : parts) {
    requireLength("neighbour '" + part.name + "': mesh deflection (chord error)", part.chordError,
                  true);
    checkRule(part.rule, "the rule of neighbour '" + part.name + "'");
  }
}

constexpr std::size_t kMaxFirst = 8;  // largest number of indices that a finding lists

void summarise(ClearanceReport& report) {
  std::vector<const NeighbourClearance*> rows;
  for (const NeighbourClearance& row : report.neighbours) rows.push_back(&row);
  const Summary summary =
      summaryOf(rows, std::to_string(rows.size()) + " checked", report.ignored.size());
  report.smallest = summary.smallest;
  report.summary = summary.text;
}

/// Returns the neighbours to check, and adds the names of the ignored neighbours to the report.
std::vector<const ClearanceNeighbour*> withoutIgnored(const std::vector<ClearanceNeighbour>& all,
                                                      ClearanceReport& report) {
  std::vector<const ClearanceNeighbour*> kept;
  for (const ClearanceNeighbour& part : all) {
    if (part.rule.ignored)
      report.ignored.push_back(part.name);
    else
      kept.push_back(&part);
  }
  if (kept.empty())
    throw Error(Status::InvalidInput, "NoNeighbours",
                "the rules ignore every neighbour; change a rule, so that at least one neighbour "
                "is checked");
  return kept;
}

/// Returns the depth (mm) up to which the rule of a row allows contact.
double allowedDepth(const NeighbourClearance& row, const ClearanceOptions& options) {
  return std::max(row.rule.contact.value_or(0), options.tolerance + row.chordError);
}

/// Adds a finding about allowed contacts for which a larger depth than allowed could not be
/// excluded. The text names the contact with the largest bound.
void warnUnproven(ClearanceReport& report, const ClearanceOptions& options) {
  Finding finding{"ContactNotProven", 0, {}, ""};
  const NeighbourClearance* worst = nullptr;
  for (std::size_t i = 0; i < report.neighbours.size(); ++i) {
    const NeighbourClearance& row = report.neighbours[i];
    if (!row.rule.contact || row.verdict != ClearanceVerdict::Contact ||
        row.penetration.depthBound <= allowedDepth(row, options))
      continue;
    ++finding.count;
    if (finding.first.size() < kMaxFirst) finding.first.push_back(static_cast<std::int64_t>(i));
    if (worst == nullptr || row.penetration.depthBound > worst->penetration.depthBound)
      worst = &row;
  }
  if (worst == nullptr) return;
  finding.text = counted(finding.count, "allowed contact") +
                 " may be deeper than the depth that was found: for '" + worst->name + "', " +
                 numberText(allowedDepth(*worst, options), 3) +
                 " mm are allowed, and no deeper point was found, but a depth of up to " +
                 numberText(worst->penetration.depthBound, 3) + " mm is possible";
  report.warnings.push_back(finding);
}

void runCheck(ClearanceReport& report, const TriMesh& body, const Trajectory& trajectory,
              const std::vector<ClearanceNeighbour>& all, const ClearanceOptions& options,
              RunContext& run) {
  Timer timer;
  run.checkpoint(Phase::Input);
  checkClearanceOptions(options, all);
  const std::vector<const ClearanceNeighbour*> neighbours = withoutIgnored(all, report);
  const Eigen::Vector3d pivot = pivotOf(trajectory);
  // Repeated poses are kept: if the body waits near a neighbour, the reported times then include
  // the wait.
  CheckedTrajectory checked = checkTrajectory(trajectory, RepeatedPoses::Keep);
  report.warnings = std::move(checked.findings);
  bool mended = false;
  const Part moving = closedPart(seenFromPivot(body, pivot), "the moving part", run, mended);
  report.bodyTriangles = std::ssize(body.triangles);
  for (const ClearanceNeighbour* part : neighbours)
    report.neighbourTriangles += std::ssize(part->mesh.triangles);
  run.checkpoint(Phase::Motion);
  const Box box = moving.box(moving.tree().root());
  const MotionTree motion(carriedByPivot(checked.trajectory, pivot), box.centre, box.half);
  report.placements = std::ssize(checked.trajectory.poses);
  report.seconds.push_back({"prepare", timer.lap()});
  report.neighbours.resize(neighbours.size());
  std::atomic<std::uint64_t> done{0};
  parallelFor(neighbours.size(), [&](std::size_t i) {
    bool neighbourMended = false;
    const ClearanceNeighbour& part = *neighbours[i];
    const Part still = closedPart(part.mesh, "neighbour '" + part.name + "'", run, neighbourMended);
    const CheckedPair pair{moving, mended, still, neighbourMended};
    NeighbourClearance& row = report.neighbours[i];
    row = checkPair(pair, {part.name, part.chordError, ruleFor(part.rule, options.required)},
                    motion, options, run);
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
  warnUnproven(report, options);
  summarise(report);
  report.seconds.push_back({"search", timer.lap()});
  report.seconds.push_back({"total", timer.seconds()});
  run.checkpoint(Phase::Done);
}

void removeRows(ClearanceReport& report) {
  report.neighbours.clear();
  report.ignored.clear();
  report.smallest.reset();
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
  fillGuarded(report, run, "clearance check", "parts and motion", removeRows,
              [&] { runCheck(report, body, trajectory, neighbours, options, run); });
  return report;
}

ClearanceReport firstContacts(const TriMesh& body, const Trajectory& trajectory,
                              const std::vector<ClearanceNeighbour>& neighbours,
                              const ClearanceOptions& options, RunContext& run) {
  // The allowed depth is a tenth larger than the depth at the first pose, because a rotating
  // bearing may lie slightly deeper at other times. It is rounded up to hundredths of a mm, which
  // are easier to read.
  constexpr double kMore = 1.1, kRound = 0.01;
  Trajectory first = trajectory;
  first.interpolation = Interpolation::None;
  if (first.poses.size() > 1) first.poses.resize(1);
  std::vector<ClearanceNeighbour> parts = neighbours;
  for (ClearanceNeighbour& part : parts) part.rule = {};
  ClearanceOptions touch = options;
  touch.required = 0;
  touch.curveSamples = 0;
  ClearanceReport report = checkClearance(body, first, parts, touch, run);
  for (NeighbourClearance& row : report.neighbours) {
    row.rule = {};
    if (row.verdict == ClearanceVerdict::Contact) row.rule.contact = 0;
    if (row.verdict == ClearanceVerdict::Clash && row.penetration.known)
      row.rule.contact = kRound * std::ceil(kMore * row.penetration.depth / kRound - 1e-6);
  }
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
