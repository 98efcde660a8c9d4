// SPDX-License-Identifier: LGPL-2.1-or-later
#include "swept/sequence.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>

#include "base/number_text.h"
#include "base/timer.h"
#include "clearance/guarded_report.h"
#include "path/assembled.h"
#include "path/given_motion.h"
#include "path/unblocked_path.h"

namespace swept {
namespace {

using namespace path;

// While the order is searched for, the number of moves per search is limited: the limit of round 1,
// the factor from round to round, and the largest limit. Round 0 uses only the quick methods.
constexpr std::int64_t kFirstMoves = 20000, kMoreMoves = 4, kMaxMoves = 1000000000;

class Sequencer {
 public:
  Sequencer(const std::vector<SequencePart>& parts, const std::vector<StillPart>& still,
            const SequenceOptions& options, RunContext& run, SequenceWatch* watch,
            SequenceReport& report)
      : parts_(parts),
        o_(options),
        run_(run),
        watch_(watch),
        report_(report),
        assembled_(parts, still, options, run) {
    report_.ignored = assembled_.ignored();
    report_.seconds.push_back({"prepare", timer_.lap()});
  }

  void findAll() {
    if (o_.findOrder)
      disassemble();
    else
      inOrder();
    run_.beginPart(0, 1);
    report_.seconds.push_back({"search", timer_.lap()});
    for (const SequenceStep& step : report_.steps) {
      report_.budgetEnded = report_.budgetEnded || step.path.budgetEnded;
      for (const Finding& finding : step.path.warnings) warn(step, finding);
    }
    if (report_.verdict == SequenceVerdict::Found)
      buildTimeline();
    else
      reportFailure();
    report_.seconds.push_back({"total", timer_.seconds()});
    run_.checkpoint(Phase::Done);
  }

 private:
  // A part whose position in the order is not known yet.
  struct Remaining {
    std::size_t part;
    PathReport last = {};
    // Round of the last search for this part. -1: there was none, or since then a part that blocked
    // it was removed.
    int tried = -1;
    bool final = false;  // proven: it cannot be removed while the other parts are there
  };

  void inOrder() {
    std::vector<char> installed(parts_.size(), 0);
    report_.verdict = SequenceVerdict::Found;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      run_.beginPart(progressAfter(i), progressAfter(i + 1));
      PathOptions options = o_.path;
      options.budgetSeconds = timeLeft() / static_cast<double>(parts_.size() - i);
      PathReport path = search(i, installed, options, i);
      if (path.status != Status::Ok)
        throw Error(path.status, path.code, "part '" + parts_[i].name + "': " + path.message);
      if (path.verdict != PathVerdict::Found) report_.verdict = SequenceVerdict::NotFound;
      report_.steps.push_back({i, std::move(path)});
      installed[i] = 1;
    }
  }

  // Finds the order backwards: the first part that can be removed is installed last. If several
  // parts can be removed, takes the one that is last in the given order. So a given order that is
  // valid stays the same.
  void disassemble() {
    std::vector<Remaining> left;
    for (std::size_t i = parts_.size(); i-- > 0;) left.push_back({i});
    std::vector<char> installed(parts_.size(), 1);
    while (!left.empty()) {
      run_.beginPart(progressAfter(report_.steps.size()), progressAfter(report_.steps.size() + 1));
      const auto out = findRemovable(left, installed);
      if (out == left.end()) break;
      const std::string& name = parts_[out->part].name;
      installed[out->part] = 0;
      report_.steps.push_back({out->part, std::move(out->last)});
      left.erase(out);
      for (Remaining& other : left) {
        const std::vector<std::string>& blockers = other.last.escape.blockers;
        const bool stays = !blockers.empty() &&
                           std::find(blockers.begin(), blockers.end(), name) == blockers.end();
        if (!stays) other.tried = -1;
        other.final = false;
      }
    }
    report_.verdict = left.empty() ? SequenceVerdict::Found : SequenceVerdict::NotFound;
    if (!left.empty() && allBlocked(left)) report_.verdict = SequenceVerdict::NoOrder;
    for (Remaining& part : left) report_.steps.push_back({part.part, std::move(part.last)});
    std::reverse(report_.steps.begin(), report_.steps.end());
  }

  // Finds the next part that can be removed. Searches become longer from round to round. Quick
  // methods are always repeated. A longer search is repeated only if a part that blocked it has
  // been removed.
  std::vector<Remaining>::iterator findRemovable(std::vector<Remaining>& left,
                                                 const std::vector<char>& installed) {
    for (int round = 0;; ++round) {
      const std::int64_t moves = moveLimit(round);
      for (auto part = left.begin(); part != left.end(); ++part) {
        if (part->final || (round > 0 && part->tried >= round)) continue;
        PathOptions options = o_.path;
        options.budgetSeconds = timeLeft();
        options.tryLowerClearance = false;
        options.mostSteps = moves;
        PathReport path = search(part->part, installed, options, parts_.size() - left.size());
        const bool occupied = path.status != Status::Ok;
        if (occupied) acceptBlockedStart(part->part, path);
        const bool found = path.verdict == PathVerdict::Found, over = path.budgetEnded;
        part->final =
            occupied || parts_[part->part].motion || path.verdict == PathVerdict::NoTranslation;
        if (found || part->final || part->tried <= round) {
          part->last = std::move(path);
          part->tried = round;
        }
        if (found) return part;
        if (over) return left.end();
      }
      const bool longest = moves >= o_.path.mostSteps.value_or(kMaxMoves);
      if (longest || allBlocked(left)) return left.end();
    }
  }

  // Returns whether all parts are proven to be blocked. Then no order exists, because one part
  // would have to be removed first, while all others are still there.
  static bool allBlocked(const std::vector<Remaining>& left) {
    return std::all_of(left.begin(), left.end(), [](const Remaining& part) { return part.final; });
  }

  // If other parts still occupy the start of a part, this part has to wait. This is not an error.
  void acceptBlockedStart(std::size_t part, PathReport& path) const {
    if (path.code != "StartBlocked" || path.status != Status::InvalidInput)
      throw Error(path.status, path.code, "part '" + parts_[part].name + "': " + path.message);
    path.summary = path.message;
    path.status = Status::Ok;
  }

  std::int64_t moveLimit(int round) const {
    std::int64_t moves = 1;
    for (int k = 0; k < round && moves < kMaxMoves; ++k)
      moves = k == 0 ? kFirstMoves : kMoreMoves * moves;
    return std::min(moves, o_.path.mostSteps.value_or(moves));
  }

  PathReport search(std::size_t i, const std::vector<char>& installed, PathOptions options,
                    std::size_t found) {
    const SequencePart& part = parts_[i];
    const std::vector<ClearanceNeighbour> neighbours = assembled_.neighboursOf(i, installed);
    ++report_.searches;
    const std::shared_ptr<PathWatch> watch = watch_ ? watch_->begin(i, found) : nullptr;
    options.bodyChordError = part.chordError;
    PathReport path;
    if (std::all_of(neighbours.begin(), neighbours.end(),
                    [](const ClearanceNeighbour& n) { return n.rule.ignored; })) {
      path = unblockedPath(part, options, assembled_.box().diagonal().norm());
    } else if (part.motion) {
      path = checkGivenMotion(part.mesh, *part.motion, neighbours, options, run_);
    } else {
      path = findPath(part.mesh, part.task, neighbours, options, run_, watch.get());
    }
    if (path.status == Status::Cancelled) throw Error(path.status, path.code, path.message);
    report_.moves += path.steps;
    return path;
  }

  double timeLeft() const { return std::max(1e-3, o_.path.budgetSeconds - timer_.seconds()); }
  double progressAfter(std::size_t done) const {
    return static_cast<double>(done) / static_cast<double>(parts_.size());
  }

  void warn(const SequenceStep& step, Finding finding) {
    finding.text = parts_[step.part].name + ": " + finding.text;
    report_.warnings.push_back(std::move(finding));
  }

  // Each part waits at its first key, moves after the parts before it, and then stays at its goal.
  void buildTimeline() {
    report_.timeline.resize(parts_.size());
    report_.clearance = std::numeric_limits<double>::infinity();
    double time = 0;
    for (SequenceStep& step : report_.steps) {
      const std::vector<Pose>& keys = step.path.path.poses;
      step.begin = time;
      for (const Pose& key : keys) {
        step.end = step.begin + key.timeSeconds - keys.front().timeSeconds;
        report_.timeline[step.part].poses.push_back(key);
        report_.timeline[step.part].poses.back().timeSeconds = step.end;
      }
      time = step.end;
      report_.clearance = std::min(report_.clearance, step.path.clearance);
    }
    report_.duration = time;
    double length = 0;
    for (const SequenceStep& step : report_.steps) {
      length += step.path.length;
      Trajectory& motion = report_.timeline[step.part];
      motion.interpolation = step.path.path.interpolation;
      motion.pivot = step.path.path.pivot;
      if (step.begin > 0) {
        motion.poses.insert(motion.poses.begin(), motion.poses.front());
        motion.poses.front().timeSeconds = 0;
      }
      if (step.end < time) {
        motion.poses.push_back(motion.poses.back());
        motion.poses.back().timeSeconds = time;
      }
    }
    report_.summary = counted(std::ssize(parts_), "part", "parts, one after the other") + ": ";
    for (const SequenceStep& step : report_.steps)
      report_.summary += (&step == &report_.steps.front() ? "" : ", ") + parts_[step.part].name;
    report_.summary += "; " + numberText(length, 4) + " mm";
    if (std::isfinite(report_.clearance))
      report_.summary += ", clearance at least " + numberText(report_.clearance, 4) + " mm";
  }

  void reportFailure() {
    std::size_t found = 0;
    std::string who;
    for (const SequenceStep& step : report_.steps) {
      if (step.path.verdict == PathVerdict::Found) {
        ++found;
        continue;
      }
      who += (who.empty() ? "" : "; ") + ("'" + parts_[step.part].name + "': ") + step.path.summary;
    }
    if (report_.verdict == SequenceVerdict::NoOrder)
      report_.summary =
          "it is proven that the parts cannot be installed one after the other in any order";
    else
      report_.summary = std::string(o_.findOrder ? "no order found" : "not all paths found") +
                        (report_.budgetEnded ? " within the time limit" : "");
    report_.summary += "; " + std::to_string(found) + " of " + std::to_string(parts_.size()) +
                       " parts have a path; " + who;
  }

  const std::vector<SequencePart>& parts_;
  const SequenceOptions& o_;
  RunContext& run_;
  SequenceWatch* watch_;
  SequenceReport& report_;
  Timer timer_;
  Assembled assembled_;
};

}  // namespace

const char* sequenceVerdictName(SequenceVerdict verdict) {
  switch (verdict) {
    case SequenceVerdict::NotFound:
      return "not_found";
    case SequenceVerdict::Found:
      return "found";
    case SequenceVerdict::NoOrder:
      return "no_order";
  }
  return "?";
}

SequenceReport findSequence(const std::vector<SequencePart>& parts,
                            const std::vector<StillPart>& still, const SequenceOptions& options,
                            RunContext& run, SequenceWatch* watch) {
  SequenceReport report;
  report.orderFound = options.findOrder;
  report.required = options.path.clearance;
  report.tolerance = options.path.tolerance;
  report.release = options.path.release;
  report.seed = options.path.seed;
  report.interpolation = interpolationName(options.path.interpolation);
  for (const SequencePart& part : parts) {
    report.names.push_back(part.name);
    report.triangles += std::ssize(part.mesh.triangles);
  }
  for (const StillPart& part : still) {
    report.still.push_back(part.name);
    report.triangles += std::ssize(part.mesh.triangles);
  }
  const auto removeResults = clearance::keepOnlyThreads<SequenceReport>;
  clearance::fillGuarded(report, run, "searches", "the parts", removeResults, [&] {
    run.checkpoint(Phase::Input);
    Sequencer(parts, still, options, run, watch, report).findAll();
  });
  run.beginPart(0, 1);
  return report;
}

}  // namespace swept
