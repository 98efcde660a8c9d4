// Checks a mechanism. The parts are prepared in parallel. Boxes over time discard the pairs of
// parts that stay far apart. Each remaining pair is searched like a moving body and a part that
// stands still. The part in whose coordinates the other one moves less counts as standing still.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "swept/mechanism.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>

#include "base/number_text.h"
#include "base/parallel.h"
#include "base/timer.h"
#include "clearance/guarded_report.h"
#include "clearance/mechanism_input.h"
#include "clearance/options_check.h"
#include "clearance/pair_check.h"
#include "clearance/pair_rules.h"
#include "clearance/stamping.h"
#include "clearance/summary.h"
#include "clearance/swept_boxes.h"
#include "motion/pivot.h"

namespace swept {
namespace {

using namespace clearance;
using Eigen::Vector3d;

void checkMechanismOptions(const std::vector<MechanismPart>& parts, const MechanismOptions& o) {
  checkSettings({o.required, o.tolerance, 0, o.intervalTolerance, o.curveSamples, o.penetration});
  if (o.range) requireLength("range", *o.range, false);
  for (const MechanismPart& part : parts)
    requireLength("part '" + part.name + "': mesh deflection (chord error)", part.chordError, true);
}

/// Returns the distance up to which pairs are measured. It is large enough for all verdicts.
double rangeOf(const std::vector<MechanismPart>& parts, const std::vector<PreparedPart>& prepared,
               const PairRules& rules, const MechanismOptions& options) {
  double range = options.range.value_or(0);
  if (!options.range) {
    std::vector<double> sizes;
    for (const PreparedPart& part : prepared) sizes.push_back(2 * part.motion.half().norm());
    const auto middle = sizes.begin() + std::ssize(sizes) / 2;
    std::nth_element(sizes.begin(), middle, sizes.end());
    range = *middle / 10;
  }
  double chord = 0;
  for (const MechanismPart& part : parts) chord = std::max(chord, part.chordError);
  return std::max(range, rules.largestRequired() + 2 * chord + 2 * options.tolerance);
}

/// Result for one pair of parts. `joined`: the parts do not move relative to each other. `near` is
/// empty if the parts are joined or never nearer than the range.
struct PairResult {
  bool joined = false;
  std::optional<PairClearance> near;
};

class MechanismPairCheck {
 public:
  MechanismPairCheck(const std::vector<MechanismPart>& parts,
                     const std::vector<PreparedPart>& prepared, const PairRules& rules,
                     const MechanismOptions& options, const MechanismReport& report,
                     RunContext& run)
      : parts_(parts),
        prepared_(prepared),
        rules_(rules),
        o_(options),
        report_(report),
        run_(run) {}

  PairResult operator()(PartPair pair) const {
    const PreparedPart& first = prepared_[pair.first];
    const PreparedPart& second = prepared_[pair.second];
    const std::vector<double> times = joinedTimes(first.motion, second.motion, report_.time);
    const double one = relativeTravel(first.motion, second.motion, times);
    const double other = relativeTravel(second.motion, first.motion, times);
    PairResult result;
    result.joined = std::min(one, other) <= o_.tolerance;
    if (result.joined) return result;
    // True: the second part is the moving body, in the frame of the first.
    const bool turned = other < one;
    const PreparedPart& body = turned ? second : first;
    const PreparedPart& frame = turned ? first : second;
    const MotionTree motion = relativeMotion(body.motion, frame.motion, times);
    const double bodyChord = parts_[turned ? pair.second : pair.first].chordError;
    const double frameChord = parts_[turned ? pair.first : pair.second].chordError;
    const NeighbourRule rule = rules_.of(pair);
    const double required = rule.required.value_or(0);
    const NeighbourClearance row = checkPair(
        {body.part, body.mended, frame.part, frame.mended, report_.range + 2 * o_.tolerance},
        {parts_[pair.first].name + " - " + parts_[pair.second].name, frameChord, rule}, motion,
        {required, o_.tolerance, bodyChord, o_.intervalTolerance, o_.curveSamples, o_.penetration},
        run_);
    if (!std::isfinite(row.distance)) return result;
    result.near = PairClearance{pair, required, poseAt(first, row.timeSeconds),
                                poseAt(second, row.timeSeconds), row};
    NeighbourClearance& found = result.near->clearance;
    toWorld(found, frame);
    if (turned) exchange(found);
    found.pose = result.near->poseOfFirst;
    found.closed = first.part.closed() && second.part.closed();
    found.penetration.pose = poseAt(first, found.penetration.timeSeconds);
    return result;
  }

 private:
  static Pose poseAt(const PreparedPart& part, double time) {
    return backFromPivot(part.motion.poseAt(time), part.pivot);
  }

  /// Transforms points and boxes from the frame of one part, which the search uses, to the world.
  static void toWorld(NeighbourClearance& row, const PreparedPart& frame) {
    const Pose at = frame.motion.poseAt(row.timeSeconds);
    for (Vector3d* x : {&row.pointOnBody, &row.pointOnNeighbour})
      *x = at.rotation * *x + at.translation;
    PenetrationResult& deep = row.penetration;
    if (!deep.known) return;
    const Pose then = frame.motion.poseAt(deep.timeSeconds);
    for (Vector3d* x : {&deep.point, &deep.surface}) *x = then.rotation * *x + then.translation;
    const Vector3d middle = 0.5 * (deep.regionMin + deep.regionMax);
    const Vector3d half = then.rotation.toRotationMatrix().cwiseAbs() *
                          Vector3d(0.5 * (deep.regionMax - deep.regionMin));
    deep.regionMin = then.rotation * middle + then.translation - half;
    deep.regionMax = then.rotation * middle + then.translation + half;
  }

  static void exchange(NeighbourClearance& row) {
    std::swap(row.pointOnBody, row.pointOnNeighbour);
    std::swap(row.bodyTriangle, row.neighbourTriangle);
    if (row.penetration.known) row.penetration.pointOfBody = !row.penetration.pointOfBody;
  }

  const std::vector<MechanismPart>& parts_;
  const std::vector<PreparedPart>& prepared_;
  const PairRules& rules_;
  const MechanismOptions& o_;
  const MechanismReport& report_;
  RunContext& run_;
};

/// Returns the pairs of parts that may come near each other. At least one part of each pair moves,
/// and no rule excludes the pair.
std::vector<PartPair> candidates(const std::vector<PreparedPart>& prepared, const PairRules& rules,
                                 const MechanismReport& report) {
  std::vector<std::optional<SweptBoxes>> built(prepared.size());
  parallelFor(prepared.size(),
              [&](std::size_t i) { built[i].emplace(prepared[i].motion, report.time); });
  std::vector<SweptBoxes> boxes;
  for (auto& box : built) boxes.push_back(std::move(*box));
  std::vector<PartPair> pairs;
  for (const auto& [first, second] : nearPairs(boxes, report.range)) {
    const bool move = prepared[first].motion.moves() || prepared[second].motion.moves();
    if (move && !rules.ignores({first, second})) pairs.push_back({first, second});
  }
  return pairs;
}

/// Counts the pairs that no rule excludes and in which at least one part moves.
std::int64_t countCheckedPairs(const std::vector<PreparedPart>& prepared, const PairRules& rules) {
  const std::int64_t all = std::ssize(prepared);
  const std::int64_t still = std::count_if(prepared.begin(), prepared.end(),
                                           [](const auto& part) { return !part.motion.moves(); });
  std::int64_t checked = all * (all - 1) / 2 - still * (still - 1) / 2;
  for (const PartPair& pair : rules.ignored())
    checked -= prepared[pair.first].motion.moves() || prepared[pair.second].motion.moves();
  return checked;
}

void addFindings(MechanismReport& report, std::vector<PreparedPart>& prepared) {
  std::vector<char> closed;
  for (PreparedPart& part : prepared) {
    for (Finding& finding : part.findings) report.warnings.push_back(std::move(finding));
    closed.push_back(part.part.closed() ? 1 : 0);
  }
  for (Finding& finding : openFindings(report.names, closed, true, "part", "parts"))
    report.warnings.push_back(std::move(finding));
}

void summarise(MechanismReport& report, std::int64_t checked) {
  std::vector<const NeighbourClearance*> rows;
  for (const PairClearance& pair : report.pairs) rows.push_back(&pair.clearance);
  std::string head = counted(checked, "pair") + " checked";
  if (rows.empty()) head += ", none closer than " + numberText(report.range, 4) + " mm";
  const Summary summary = summaryOf(rows, head);
  report.smallest = summary.smallest;
  report.summary = summary.text;
}

void runCheck(MechanismReport& report, const std::vector<MechanismPart>& parts,
              const MechanismOptions& options, RunContext& run) {
  Timer timer;
  run.checkpoint(Phase::Input);
  checkMechanismOptions(parts, options);
  for (const MechanismPart& part : parts) {
    report.names.push_back(part.name);
    report.triangles += std::ssize(part.mesh.triangles);
  }
  const PairRules rules(report.names, options);
  std::vector<PreparedPart> prepared = prepareParts(parts, run);
  report.time = commonTime(parts, prepared, report.warnings);
  report.range = rangeOf(parts, prepared, rules, options);
  report.ignored = rules.ignored();
  report.seconds.push_back({"prepare", timer.lap()});
  run.checkpoint(Phase::Motion);
  const std::vector<PartPair> pairs = candidates(prepared, rules, report);
  report.seconds.push_back({"boxes", timer.lap()});
  std::vector<PairResult> results(pairs.size());
  const MechanismPairCheck check(parts, prepared, rules, options, report, run);
  std::atomic<std::uint64_t> done{0};
  parallelFor(pairs.size(), [&](std::size_t i) {
    // While a thread waits for others that work on its pair, it must not start a second pair, which
    // would take more memory.
    tbb::this_task_arena::isolate([&] { results[i] = check(pairs[i]); });
    run.checkpoint(Phase::Check, ++done, pairs.size());
  });
  const std::int64_t checked = countCheckedPairs(prepared, rules);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (results[i].joined) report.joined.push_back(pairs[i]);
    if (results[i].near) report.pairs.push_back(std::move(*results[i].near));
  }
  report.farPairs = checked - std::ssize(report.joined) - std::ssize(report.pairs);
  addFindings(report, prepared);
  summarise(report, checked - std::ssize(report.joined));
  report.seconds.push_back({"search", timer.lap()});
  report.seconds.push_back({"total", timer.seconds()});
  run.checkpoint(Phase::Done);
}

void removePairs(MechanismReport& report) {
  report.pairs.clear();
  report.ignored.clear();
  report.joined.clear();
  report.farPairs = 0;
  report.smallest.reset();
  report.summary.clear();
}

}  // namespace

MechanismReport checkMechanism(const std::vector<MechanismPart>& parts,
                               const MechanismOptions& options, RunContext& run) {
  MechanismReport report;
  report.required = options.required;
  report.tolerance = options.tolerance;
  fillGuarded(report, run, "check of the mechanism", "parts and motions", removePairs,
              [&] { runCheck(report, parts, options, run); });
  return report;
}

StampedClearance stampedPair(const MechanismPart& first, const MechanismPart& second,
                             const TimeInterval& time, int between, RunContext& run) {
  std::vector<Finding> findings;
  const TimedMotion a(timedPoses(first, findings), Vector3d::Zero(), Vector3d::Ones());
  const TimedMotion b(timedPoses(second, findings), Vector3d::Zero(), Vector3d::Ones());
  const std::vector<double> poses = joinedTimes(a, b, time);
  std::vector<double> times{poses.front()};
  for (std::size_t i = 1; i < poses.size(); ++i)
    for (int k = 1; k <= between + 1; ++k)
      times.push_back(poses[i - 1] + (poses[i] - poses[i - 1]) * k / (between + 1));
  std::vector<Pose> ofFirst, ofSecond;
  for (const double at : times) {
    ofFirst.push_back(backFromPivot(a.poseAt(at), pivotOf(first.motion)));
    ofSecond.push_back(backFromPivot(b.poseAt(at), pivotOf(second.motion)));
  }
  const StampedMinimum least = stampEveryPose(first.mesh, ofFirst, second.mesh, ofSecond, run);
  return {least.distance, times[least.pose], std::ssize(times)};
}

}  // namespace swept
