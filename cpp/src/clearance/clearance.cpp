// SPDX-License-Identifier: LGPL-2.1-or-later
#include "swept/clearance.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <chrono>
#include <cmath>
#include <string>

#include "base/limits.h"
#include "base/number_text.h"
#include "base/threads.h"
#include "clearance/penetration.h"
#include "input/body_check.h"
#include "input/trajectory_check.h"
#include "motion/pivot.h"

namespace swept {
namespace {

using namespace clearance;

/// Neighbours that one sentence names; a reader asks for the first few.
constexpr std::size_t kMaxNamedOpen = 8;
using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

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

/// The mesh as a part; of a welded and turned copy if the mesh itself is not closed but that
/// is.
Part closedPart(const TriMesh& mesh, const std::string& who, RunContext& run, bool& mended) {
  Part part(mesh, who);
  if (part.closed()) return part;
  try {
    const CheckedBody checked = checkBody(mesh, Options{}, run);
    if (!checked.orientable) return part;
    mended = true;
    return Part(checked.mesh, who);
  } catch (const Error& error) {
    if (error.status() == Status::InvalidInput)
      return part;  // e.g. a flat sheet: still a neighbour
    throw;
  }
}

/// One neighbour from its mesh to its row of the report.
class NeighbourCheck {
 public:
  NeighbourCheck(const Part& body, bool bodyMended, const MotionTree& motion,
                 const ClearanceOptions& options, RunContext& run)
      : body_(body), bodyMended_(bodyMended), motion_(motion), o_(options), run_(run) {}

  NeighbourClearance operator()(const ClearanceNeighbour& part) const {
    const Clock::time_point start = Clock::now();
    bool mended = false;
    const Part neighbour = closedPart(part.mesh, "neighbour '" + part.name + "'", run_, mended);
    const PairSearch pair(body_, neighbour);
    SearchContext context{pair, motion_, run_};
    NeighbourClearance row;
    row.name = part.name;
    row.chordError = o_.bodyChordError + part.chordError;
    row.closed = neighbour.closed();
    const double touch = o_.tolerance + row.chordError;
    const double slack = motion_.isContinuous() ? o_.tolerance : 0.0;
    Minimum least = searchMinimum(context, slack);
    row.inside = least.inside;
    if (least.inside || least.distance <= slack) {
      row.penetration =
          deepestPenetration(context, least, o_.tolerance, o_.penetration ? 40000 : 4000);
      const bool undecidable =
          !row.penetration.known && least.distance <= 0 && !body_.closed() && !neighbour.closed();
      if (row.penetration.depth > touch || undecidable)
        row.verdict = ClearanceVerdict::Clash;
      else
        row.verdict = ClearanceVerdict::Contact;
    } else if (least.distance <= touch) {
      row.verdict = ClearanceVerdict::Contact;
    }
    fillMinimum(row, least, pair);
    if (mended) row.neighbourTriangle = -1;  // the numbers of the copy mean nothing to the caller
    if (bodyMended_) row.bodyTriangle = -1;
    row.guaranteed = std::max(0.0, row.distance - slack - row.chordError);
    const bool below = o_.required > 0 && row.distance - row.chordError < o_.required;
    if (row.verdict == ClearanceVerdict::Clear && below)
      row.verdict = ClearanceVerdict::BelowRequired;
    fillSpans(row, context, touch, below);
    for (const auto& [u, d] :
         sampleDistances(context, o_.curveSamples, parameterOfMinimum(row, least)))
      row.curve.push_back({motion_.timeAt(u), d});
    row.distanceQueries = context.queries;
    row.certificates = context.certificates;
    row.seconds = secondsSince(start);
    return row;
  }

 private:
  double parameterOfMinimum(const NeighbourClearance& row, const Minimum& least) const {
    return row.verdict == ClearanceVerdict::Clash && row.penetration.known
               ? row.penetration.parameter
               : least.parameter;
  }

  void fillMinimum(NeighbourClearance& row, const Minimum& least, const PairSearch& pair) const {
    const bool clash = row.verdict == ClearanceVerdict::Clash && row.penetration.known;
    row.distance = clash ? 0.0 : least.distance;
    row.pose = motion_.poseAt(parameterOfMinimum(row, least));
    row.timeSeconds = row.pose.timeSeconds;
    if (clash) {
      row.pointOnBody =
          row.penetration.pointOfBody ? row.penetration.point : row.penetration.surface;
      row.pointOnNeighbour =
          row.penetration.pointOfBody ? row.penetration.surface : row.penetration.point;
      return;
    }
    if (least.at.pair.body < 0) return;
    row.pointOnBody = least.at.onBody;
    row.pointOnNeighbour = least.at.onNeighbour;
    row.bodyTriangle = pair.body().triangle(least.at.pair.body);
    row.neighbourTriangle = pair.neighbour().triangle(least.at.pair.neighbour);
  }

  void fillSpans(NeighbourClearance& row, SearchContext& context, double touch, bool below) const {
    const double resolution = !motion_.isContinuous()    ? 0.0
                              : o_.intervalTolerance > 0 ? o_.intervalTolerance
                                                         : 10 * o_.tolerance;
    const OverlapTest overlaps = [&](const Eigen::Matrix3d& R, const Eigen::Vector3d& t, double d) {
      return overlapsBy(context.pair, R, t, d);
    };
    const auto timesBelow = [&](double level) {
      std::vector<TimeInterval> times;
      for (const auto& [from, to] : spansBelow(context, level, resolution, overlaps))
        times.push_back({motion_.timeAt(from), motion_.timeAt(to)});
      return times;
    };
    if (below) row.below = timesBelow(o_.required + row.chordError);
    if (row.verdict >= ClearanceVerdict::Contact) row.contact = timesBelow(touch);
  }

  const Part& body_;
  bool bodyMended_;
  const MotionTree& motion_;
  const ClearanceOptions& o_;
  RunContext& run_;
};

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
  const double length = deep ? row.penetration.depth : std::max(0.0, row.distance - row.chordError);
  report.summary += std::string(deep ? ", deepest " : ", smallest ") + numberText(length, 4) +
                    " mm at t = " + numberText(row.timeSeconds) + " s";
  if (!row.name.empty()) report.summary += " (" + row.name + ")";
}

void warnOpen(ClearanceReport& report, bool bodyClosed) {
  Finding open{"OpenMesh", 0, {}, ""};
  std::string names;
  for (std::size_t i = 0; i < report.neighbours.size(); ++i) {
    if (report.neighbours[i].closed) continue;
    ++open.count;
    if (open.first.size() >= kMaxNamedOpen) continue;
    open.first.push_back(static_cast<std::int64_t>(i));
    const std::string& name = report.neighbours[i].name;
    names += (names.empty() ? "" : ", ") + (name.empty() ? std::to_string(i + 1) : name);
  }
  if (open.count > 0) {
    if (static_cast<std::size_t>(open.count) > open.first.size()) names += ", ...";
    open.text =
        std::to_string(open.count) + (open.count == 1 ? " neighbour is" : " neighbours are") +
        " open or badly oriented (" + names +
        "): a part that lies wholly inside such a surface is not noticed, and depth is measured on "
        "the other side only";
    report.warnings.push_back(open);
  }
  if (!bodyClosed)
    report.warnings.push_back({"OpenBody",
                               1,
                               {},
                               "the moving body is an open or badly oriented surface: a neighbour "
                               "that lies wholly inside it is not noticed"});
}

void runCheck(ClearanceReport& report, const TriMesh& body, const Trajectory& trajectory,
              const std::vector<ClearanceNeighbour>& neighbours, const ClearanceOptions& options,
              RunContext& run) {
  const Clock::time_point start = Clock::now();
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
  report.seconds.push_back({"prepare", secondsSince(start)});
  const Clock::time_point search = Clock::now();
  report.neighbours.resize(neighbours.size());
  std::atomic<std::uint64_t> done{0};
  const NeighbourCheck check(moving, mended, motion, options, run);
  tbb::parallel_for(std::size_t{0}, neighbours.size(), [&](std::size_t i) {
    report.neighbours[i] = check(neighbours[i]);
    NeighbourClearance& row = report.neighbours[i];
    row.pose = backFromPivot(row.pose, pivot);
    row.penetration.pose = backFromPivot(row.penetration.pose, pivot);
    run.checkpoint(Phase::Check, ++done, neighbours.size());
  });
  warnOpen(report, moving.closed());
  summarise(report);
  report.seconds.push_back({"search", secondsSince(search)});
  report.seconds.push_back({"total", secondsSince(start)});
  run.checkpoint(Phase::Done);
}

void fail(ClearanceReport& report, Status status, const std::string& code,
          const std::string& text) {
  report.status = status;
  report.code = code;
  report.message = text;
  report.neighbours.clear();  // a run that did not finish must not look like a result
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
  try {
    report.threads = threadsOf(run);
    tbb::task_arena arena(report.threads);
    arena.execute([&] { runCheck(report, body, trajectory, neighbours, options, run); });
  } catch (const Error& e) {
    fail(report, e.status(), e.code(), e.what());
  } catch (const std::bad_alloc&) {
    fail(report, Status::OutOfMemory, "OutOfMemory",
         "not enough memory for the clearance check; use coarser neighbours or fewer at a time");
  } catch (const std::exception& e) {
    fail(
        report, Status::InternalError, "InternalError",
        std::string(e.what()) + ": a fault of the program; please report it with parts and motion");
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
