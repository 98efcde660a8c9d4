// SPDX-License-Identifier: LGPL-2.1-or-later
#include "path/given_motion.h"

#include <algorithm>

#include "base/number_text.h"
#include "base/timer.h"
#include "clearance/pair_check.h"
#include "motion/pivot.h"
#include "path/found_path.h"
#include "path/guarded_path.h"
#include "path/task_check.h"

namespace swept::path {
namespace {

constexpr int kHalvings = 40;  // steps of bisection to find the end of a release zone

class GivenMotion {
 public:
  GivenMotion(const TriMesh& part, const Trajectory& motion,
              const std::vector<ClearanceNeighbour>& neighbours, const PathOptions& options,
              RunContext& run, PathReport& report)
      : o_(options),
        run_(run),
        report_(report),
        scene_(part, neighbours, options, run),
        demand_(demandOf(neighbours, options)) {
    for (std::size_t i = 0; i < motion.poses.size(); ++i) {
      const Pose& pose = motion.poses[i];
      keys_.push_back({scene_.inside(checkedPose(pose, keyName(i))), pose.timeSeconds});
    }
  }

  void check() {
    std::vector<char> closed;
    for (std::size_t i = 0; i < scene_.count(); ++i)
      closed.push_back(scene_.neighbour(i).closed() ? 1 : 0);
    report_.warnings = clearance::openFindings(demand_.names, closed, scene_.part().closed());
    const End start = examineContacts(scene_, demand_, keys_.front().state, "the start", run_);
    const End goal = examineContacts(scene_, demand_, keys_.back().state, "the goal", run_);
    std::vector<State> states;
    for (const Key& key : keys_) states.push_back(key.state);
    addLength(states, report_);
    const std::size_t first = touches(start) ? cutAtStart() : 0;
    const std::size_t last = touches(goal) ? cutAtGoal() : keys_.size() - 1;
    if (first >= last)
      throw Error(
          Status::InvalidInput, "BadOption",
          "during the whole motion, the part stays within the release distance of " +
              numberText(o_.release, 4) +
              " mm from its start or its goal. Contact is allowed there, so nothing would be "
              "checked; choose a smaller release distance");
    report_.certificate = checked(part(first, last), demand_.apart);
    checkZone(start, "start", part(0, first));
    checkZone(goal, "goal", part(last, keys_.size() - 1));
    if (!report_.escape.blockers.empty()) return;
    report_.verdict = PathVerdict::Found;
    report_.method = "given";
    report_.clearance = provenClearance(report_.certificate, demand_);
    for (std::size_t i = 0; i < scene_.count(); ++i)
      if (start.allowedDepth[i] >= 0 || goal.allowedDepth[i] >= 0)
        report_.contacts.push_back(demand_.names[i]);
  }

  double seconds() const { return timer_.seconds(); }

 private:
  struct Key {
    State state;
    double time;
  };

  static bool touches(const End& end) {
    return std::any_of(end.allowedDepth.begin(), end.allowedDepth.end(),
                       [](double depth) { return depth >= 0; });
  }

  bool released(const State& state, const State& end) const {
    return scene_.distance(state, end) <= o_.release;
  }

  // Adds a key where the motion enters the release zone of the goal for the last time. Returns its
  // index.
  std::size_t cutAtGoal() {
    const State goal = keys_.back().state;
    std::size_t i = keys_.size() - 1;
    while (i > 0 && released(keys_[i - 1].state, goal)) --i;
    return i == 0 ? 0 : insertBetween(i - 1, goal, false);
  }

  // Adds a key where the motion leaves the release zone of the start for the first time. Returns
  // its index.
  std::size_t cutAtStart() {
    const State start = keys_.front().state;
    std::size_t i = 0;
    while (i + 1 < keys_.size() && released(keys_[i + 1].state, start)) ++i;
    return i + 1 == keys_.size() ? i : insertBetween(i, start, true);
  }

  // Adds a key where the motion crosses the border of the release zone of `end`, between key i and
  // the next key. Exactly one of these two keys must lie in the zone. The new key lies just inside.
  // Returns its index.
  std::size_t insertBetween(std::size_t i, const State& end, bool zoneFirst) {
    const Key a = keys_[i], b = keys_[i + 1];
    double in = zoneFirst ? 0 : 1, out = 1 - in;
    for (int k = 0; k < kHalvings; ++k) {
      const double middle = 0.5 * (in + out);
      (released(scene_.stateBetween(a.state, b.state, middle), end) ? in : out) = middle;
    }
    const Key cut{scene_.stateBetween(a.state, b.state, in), a.time + in * (b.time - a.time)};
    if (in <= 0) return i;
    if (in >= 1) return i + 1;
    keys_.insert(keys_.begin() + static_cast<std::ptrdiff_t>(i) + 1, cut);
    return i + 1;
  }

  Trajectory part(std::size_t first, std::size_t last) const {
    Trajectory cut{{}, o_.interpolation};
    for (std::size_t i = first; i <= last; ++i) {
      cut.poses.push_back(keys_[i].state.pose);
      cut.poses.back().timeSeconds = keys_[i].time;
    }
    return cut;
  }

  // Checks the motion in the release zone of an end. There, the part must keep the required
  // distance from neighbours that it does not touch at the end. In the other neighbours, it must
  // not lie deeper than at the end. `where`: "start" or "goal".
  void checkZone(const End& end, const char* where, const Trajectory& motion) {
    if (motion.poses.size() < 2) return;
    checked(motion, end.ruleInside(demand_));
    for (std::size_t i = 0; i < scene_.count(); ++i) {
      if (end.allowedDepth[i] < 0) continue;
      End only{end.state, std::vector<double>(scene_.count(), -1), {}};
      only.allowedDepth[i] = end.allowedDepth[i];
      if (staysWithinDepth(scene_, demand_, only, motion, run_)) continue;
      fail(
          demand_.names[i], scene_.at(motion.poses.front()),
          textOf(4, "within the release distance of ", o_.release, " mm from its ", where,
                 ", the part may overlap '", demand_.names[i], "' by at most ", end.allowedDepth[i],
                 " mm, but it overlaps more deeply there, or by an unknown depth; change the "
                 "motion there"));
    }
  }

  std::vector<NeighbourClearance> checked(const Trajectory& motion, const Rule& rule) {
    std::vector<NeighbourClearance> rows = certificateOf(scene_, demand_, motion, rule, run_);
    for (const NeighbourClearance& row : rows)
      if (row.verdict != ClearanceVerdict::Clear)
        fail(row.name, scene_.at(row.pose), nearText(row));
    toCallerWorld(scene_, rows);
    return rows;
  }

  std::string nearText(const NeighbourClearance& row) const {
    const std::string when = textOf(4, "at t = ", row.timeSeconds, " s the part ");
    if (row.verdict == ClearanceVerdict::Clash) {
      const std::string depth =
          row.penetration.known ? textOf(4, ", ", row.penetration.depth, " mm deep") : "";
      return when + "overlaps '" + row.name + "'" + depth + "; change the motion there";
    }
    const auto name = std::find(demand_.names.begin(), demand_.names.end(), row.name);
    const double required =
        demand_.required[static_cast<std::size_t>(name - demand_.names.begin())];
    return when + "is " + numberText(std::max(0.0, row.distance - row.chordError), 6) +
           " mm from '" + row.name + "', " + requiredText(required, demand_.tolerance) +
           "change the motion there";
  }

  void fail(const std::string& name, const State& where, const std::string& text) {
    if (report_.escape.blockers.empty()) {
      report_.summary = text;
      report_.escape.pose = scene_.outside(where);
      report_.escape.distance = (where.middle - keys_.back().state.middle).norm();
    }
    report_.escape.blockers.push_back(name);
  }

  const PathOptions& o_;
  RunContext& run_;
  PathReport& report_;
  Timer timer_;
  Scene scene_;
  Demand demand_;
  std::vector<Key> keys_;
};

}  // namespace

PathReport checkGivenMotion(const TriMesh& part, const Trajectory& motion,
                            const std::vector<ClearanceNeighbour>& neighbours,
                            const PathOptions& options, RunContext& run) {
  PathOptions o = options;
  o.interpolation = motion.interpolation;
  return guardedPath(part, neighbours, o, run, [&](PathReport& report, const auto& counted) {
    // The pivot moves along straight lines. All computations use coordinates whose origin is the
    // pivot.
    const Eigen::Vector3d pivot = pivotOf(motion);
    GivenMotion given(seenFromPivot(part, pivot), carriedByPivot(motion, pivot), counted, o, run,
                      report);
    given.check();
    report.escape.pose = backFromPivot(report.escape.pose, pivot);
    if (report.verdict == PathVerdict::Found) {
      report.path = motion;
      report.summary = figuresText(report);
    }
    return given.seconds();
  });
}

}  // namespace swept::path
