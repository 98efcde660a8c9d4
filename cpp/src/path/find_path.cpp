// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/fault_text.h"
#include "base/number_text.h"
#include "clearance/pair_check.h"
#include "path/found_path.h"
#include "path/guarded_path.h"
#include "path/ladder.h"
#include "path/outside.h"
#include "path/polish.h"
#include "path/task_check.h"
#include "path/widen.h"
#include "swept/path.h"

namespace swept {
namespace {

using namespace path;

class PathFinder {
 public:
  PathFinder(const TriMesh& part, const PathTask& task,
             const std::vector<ClearanceNeighbour>& neighbours, const PathOptions& options,
             RunContext& run, PathWatch* watch, PathReport& report)
      : o_(options),
        task_(task),
        run_(run),
        report_(report),
        scene_(part, neighbours, options, run),
        limits_{timer_, options.budgetSeconds, options.seed, watch, options.mostSteps},
        demand_(demandOf(neighbours, options)) {}

  void search() {
    prepare();
    report_.seconds.push_back({"prepare", timer_.lap()});
    std::vector<State> keys;
    std::string method;
    for (std::size_t leg = 0; leg + 1 < ends_.size(); ++leg) {
      LegResult found = solve(leg);
      report_.steps += found.steps;
      if (found.keys.empty()) {
        report_.seconds.push_back({"search", timer_.lap()});
        storeFailure(found);
        return;
      }
      if (method.empty() || found.method == "six dimensions") method = found.method;
      polishLeg(leg, found.keys);
      if (!keys.empty()) keys.pop_back();
      keys.insert(keys.end(), found.keys.begin(), found.keys.end());
    }
    report_.method = method;
    report_.seconds.push_back({"search", timer_.lap()});
    storePath(keys);
    report_.seconds.push_back({"certify", timer_.lap()});
  }

  double seconds() const { return timer_.seconds(); }

 private:
  // The path consists of legs: from the start to the first via pose, and so on to the goal.
  // Examines the ends of all legs: the start (or several placements outside), the via poses, the
  // goal.
  void prepare() {
    const State goal = scene_.inside(checkedPose(task_.goal, "the goal"));
    space_.upright = goal.pose.rotation;
    space_.largestTurn = o_.translationOnly ? 0 : o_.largestTurn.value_or(4.0);
    ends_.push_back(examineEnd(scene_, demand_, goal, "the goal", run_));
    for (std::size_t i = task_.via.size(); i-- > 0;) {
      const std::string name = viaName(i + 1);
      ends_.push_back(
          examineEnd(scene_, demand_, scene_.inside(checkedPose(task_.via[i], name)), name, run_));
    }
    if (task_.start) {
      const State start = scene_.inside(checkedPose(*task_.start, "the start"));
      if (ends_.size() == 1 && scene_.distance(start, goal) < 1e-6 * scene_.radius())
        throw Error(Status::InvalidInput, "SamePose",
                    "start and goal are the same placement; choose another start or goal");
      ends_.push_back(examineEnd(scene_, demand_, start, "the start", run_));
    } else {
      Extraction extraction = *task_.extraction;
      if (extraction.direction)
        extraction.direction = Eigen::Vector3d(scene_.world() * *extraction.direction);
      ends_.push_back(outside(scene_, demand_, goal, extraction));
      if (task_.via.empty()) space_.isOut = outsideTest(scene_, demand_, goal, extraction);
    }
    std::reverse(ends_.begin(), ends_.end());
    requireAllowedTurns();
    std::vector<char> closed;
    for (std::size_t i = 0; i < scene_.count(); ++i)
      closed.push_back(scene_.neighbour(i).closed() ? 1 : 0);
    report_.warnings = clearance::openFindings(demand_.names, closed, scene_.part().closed());
    Eigen::AlignedBox3d box = scene_.box();
    const double most = *std::max_element(demand_.apart.begin(), demand_.apart.end());
    const Eigen::Vector3d margin = Eigen::Vector3d::Constant(1.5 * scene_.radius() + most);
    box.extend(Eigen::AlignedBox3d(Eigen::Vector3d(box.min() - margin),
                                   Eigen::Vector3d(box.max() + margin)));
    for (const End& end : ends_)
      for (const auto& keys : end.exits)
        for (const State& state : {keys.front(), keys.back()}) {
          box.extend(
              Eigen::Vector3d(state.middle - Eigen::Vector3d::Constant(0.2 * scene_.radius())));
          box.extend(
              Eigen::Vector3d(state.middle + Eigen::Vector3d::Constant(0.2 * scene_.radius())));
        }
    space_.low = box.min();
    space_.high = box.max();
  }

  void requireAllowedTurns() const {
    constexpr double kDegrees = 180 / std::numbers::pi;
    for (std::size_t i = 0; i < ends_.size(); ++i)
      for (const auto& keys : ends_[i].exits) {
        const double turn = keys.front().pose.rotation.angularDistance(space_.upright);
        if (turn <= std::max(space_.largestTurn, 1e-6)) continue;
        const std::string where = i == 0 ? "the start" : viaName(i);
        const std::string limit =
            o_.translationOnly
                ? "no turns are allowed"
                : textOf(6, "at most ", space_.largestTurn * kDegrees, " degrees are allowed");
        throw Error(Status::InvalidInput, "BadOption",
                    textOf(6, where, " is turned by ", turn * kDegrees,
                           " degrees relative to the goal, but ", limit,
                           "; change the placement, or allow larger turns"));
      }
  }

  LegResult solve(std::size_t leg) {
    Leg task;
    task.space = space_;
    if (leg > 0) task.space.isOut = nullptr;
    for (const auto& exit : ends_[leg].exits) task.starts.push_back(exit.back());
    for (const auto& exit : ends_[leg + 1].exits) task.goals.push_back(exit.back());
    task.far = (space_.high - space_.low).norm();
    if (task.goals.empty() || (task.starts.empty() && !task.space.isOut)) {
      LegResult none;
      none.farthest = ends_[leg + 1].state;
      none.blocked.assign(scene_.count(), 0);
      for (std::size_t i = 0; i < scene_.count(); ++i)
        none.blocked[i] = ends_[leg + 1].allowedDepth[i] >= 0 ? 1 : 0;
      return none;
    }
    // If the task gives only a radius, no proof is possible. The part may be this far from its goal
    // while it is still inside the region that the proof covers.
    task.provable = !ends_[leg].touches() && !ends_[leg + 1].touches() &&
                    (task_.start || task_.extraction->direction);
    // Part of the time is reserved to find the largest clearance for which there is a path.
    const bool mayReduceClearance =
        o_.tryLowerClearance &&
        *std::max_element(demand_.required.begin(), demand_.required.end()) > 2 * demand_.tolerance;
    Limits limits = limits_;
    limits.seconds = (mayReduceClearance ? 0.75 : 1.0) * o_.budgetSeconds;
    LegResult found = solveLeg(scene_, demand_.apart, task, limits, run_);
    if (!found.keys.empty() || found.noTranslation || !mayReduceClearance) return found;
    task.provable = false;
    for (const double fraction : {0.5, 0.25, 0.0}) {
      limits.seconds += o_.budgetSeconds / 12;
      Rule less = demand_.apart;
      for (std::size_t i = 0; i < less.size(); ++i)
        less[i] += std::max(fraction * demand_.required[i], demand_.tolerance) -
                   std::max(demand_.required[i], demand_.tolerance);
      const LegResult other = solveLeg(scene_, less, task, limits, run_);
      found.steps += other.steps;
      if (other.keys.empty()) continue;
      report_.possibleClearance = fraction * o_.clearance;
      break;
    }
    return found;
  }

  // Returns the exit from contact that leads from the end to the state. If there is none, returns
  // the state alone.
  static std::vector<State> exitTo(const End& end, const State& state) {
    for (const auto& exit : end.exits)
      if (exit.back().pose.translation == state.pose.translation &&
          exit.back().pose.rotation.coeffs() == state.pose.rotation.coeffs())
        return exit;
    return {state};
  }

  void polishLeg(std::size_t leg, std::vector<State>& keys) {
    RandomNumbers random(o_.seed + leg);
    const MoveAllowed allowed = turnLimit(scene_, space_);
    const State first = keys.front(), last = keys.back();
    shorten(scene_, demand_.apart, allowed, kShortcuts, random, keys, run_);
    widen(scene_, demand_.apart, {allowed, space_.turns(), [this] { return limits_.over(); }},
          random, keys, run_);
    const std::vector<State> in = exitTo(ends_[leg + 1], last), out = exitTo(ends_[leg], first);
    released_.push_back({out.size() - 1, in.size() - 1});
    std::vector<State> all(out.begin(), out.end() - 1);
    all.insert(all.end(), keys.begin(), keys.end());
    all.insert(all.end(), in.rbegin() + 1, in.rend());
    keys = std::move(all);
  }

  Trajectory motionOf(const std::vector<State>& keys) const {
    Trajectory motion{{}, o_.interpolation};
    double time = 0;
    for (std::size_t i = 0; i < keys.size(); ++i) {
      if (i > 0) time += std::max(1e-6, scene_.distance(keys[i - 1], keys[i]) / kPathSpeed);
      motion.poses.push_back(keys[i].pose);
      motion.poses.back().timeSeconds = time;
    }
    return motion;
  }

  static Trajectory part(const Trajectory& motion, std::size_t first, std::size_t last) {
    Trajectory cut{{motion.poses.begin() + static_cast<std::ptrdiff_t>(first),
                    motion.poses.begin() + static_cast<std::ptrdiff_t>(last) + 1},
                   motion.interpolation};
    return cut;
  }

  std::vector<NeighbourClearance> check(const Trajectory& motion, const Rule& rule) const {
    return certificateOf(scene_, demand_, motion, rule, run_);
  }

  void storePath(const std::vector<State>& keys) {
    const Trajectory motion = motionOf(keys);
    const std::size_t last = keys.size() - 1;
    const std::size_t begin = released_.front().before, end = last - released_.back().after;
    bool good = true;
    if (begin > 0)
      good = allClear(check(part(motion, 0, begin), ends_.front().ruleInside(demand_)));
    if (end < last)
      good = good && allClear(check(part(motion, end, last), ends_.back().ruleInside(demand_)));
    report_.certificate = check(part(motion, begin, end), demand_.apart);
    if (!good || !allClear(report_.certificate))
      throw Error(Status::InternalError, "NotCertified",
                  "a path was found, but the final check did not confirm that it is clear" +
                      faultText("the parts"));
    report_.verdict = PathVerdict::Found;
    report_.path = motion;
    for (std::size_t i = 0; i < keys.size(); ++i) {
      Pose& pose = report_.path.poses[i];
      pose = scene_.outside(keys[i]);
      pose.timeSeconds = motion.poses[i].timeSeconds;
    }
    restorePose(report_.path.poses.back(), task_.goal);
    if (task_.start) restorePose(report_.path.poses.front(), *task_.start);
    toCallerWorld(scene_, report_.certificate);
    report_.clearance = provenClearance(report_.certificate, demand_);
    addLength(keys, report_);
    for (std::size_t i = 0; i < scene_.count(); ++i)
      if (ends_.front().allowedDepth[i] >= 0 || ends_.back().allowedDepth[i] >= 0)
        report_.contacts.push_back(demand_.names[i]);
    report_.summary = figuresText(report_);
  }

  // Replaces a pose of the path by the given pose, because conversions have rounded it.
  static void restorePose(Pose& pose, const Pose& given) {
    pose.translation = given.translation;
    pose.rotation = given.rotation.normalized();
  }

  void storeFailure(const LegResult& found) {
    report_.budgetEnded = limits_.over();
    if (found.noTranslation) report_.verdict = PathVerdict::NoTranslation;
    const Eigen::Vector3d goal = ends_.back().state.middle;
    report_.escape.distance = (found.farthest.middle - goal).norm();
    report_.escape.pose = scene_.outside(found.farthest);
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < scene_.count(); ++i)
      if (found.blocked[i] > 0) order.push_back(i);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return found.blocked[a] > found.blocked[b];
    });
    for (const std::size_t i : order) report_.escape.blockers.push_back(demand_.names[i]);
    if (report_.verdict == PathVerdict::NoTranslation)
      report_.summary = "it is proven that no path exists without turning the part";
    else
      report_.summary =
          "no path found" + std::string(report_.budgetEnded ? " within the time limit" : "");
    if (report_.possibleClearance)
      report_.summary += "; a path with a clearance of " +
                         numberText(*report_.possibleClearance, 4) + " mm was found";
    report_.summary += "; the part got at most " + numberText(report_.escape.distance, 4) +
                       " mm away from its goal";
    if (!order.empty())
      report_.summary += "; most frequent obstacle: '" + demand_.names[order[0]] + "'";
  }

  struct Released {
    std::size_t before, after;
  };
  const PathOptions& o_;
  const PathTask& task_;
  RunContext& run_;
  PathReport& report_;
  Timer timer_;
  Scene scene_;
  Limits limits_;
  Demand demand_;
  SearchSpace space_;
  std::vector<End> ends_;
  std::vector<Released> released_;  ///< for each leg, the keys in release zones
};

}  // namespace

const char* pathVerdictName(PathVerdict verdict) {
  switch (verdict) {
    case PathVerdict::NotFound:
      return "not_found";
    case PathVerdict::Found:
      return "found";
    case PathVerdict::NoTranslation:
      return "no_translation";
  }
  return "?";
}

PathReport findPath(const TriMesh& part, const PathTask& task,
                    const std::vector<ClearanceNeighbour>& neighbours, const PathOptions& options,
                    RunContext& run, PathWatch* watch) {
  return guardedPath(part, neighbours, options, run, [&](PathReport& report, const auto& counted) {
    checkPathOptions(task, counted, options);
    PathFinder finder(part, task, counted, options, run, watch, report);
    finder.search();
    return finder.seconds();
  });
}

}  // namespace swept
