// Improves an existing motion. Pieces that keep the clearance are shortened. For each other piece,
// a new path between its two ends is searched for.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>

#include "base/fault_text.h"
#include "clearance/pair_check.h"
#include "motion/pivot.h"
#include "path/found_path.h"
#include "path/guarded_path.h"
#include "path/ladder.h"
#include "path/polish.h"
#include "path/task_check.h"
#include "path/widen.h"
#include "swept/path.h"

namespace swept {
namespace {

using namespace path;

constexpr double kMinRaise = 1.05;  // raising ends when the factor is not larger than this
constexpr double kRaise = 1.5;      // first factor from one clearance to the next
// If only the beginning of a move is proven free, a free piece takes this fraction of it.
constexpr double kGapFraction = 0.98;
// Smallest length of a new piece of a move, in radii of the part.
constexpr double kMinPieceLength = 1e-4;
constexpr double kBudgetFraction = 0.25;  // fraction of the budget for one search

struct Piece {
  std::vector<State> keys;  // consecutive
  bool free = false;        // true: all moves between the keys are proven to keep the rule
};

// The pieces between two consecutive locked keys.
using Stretch = std::vector<Piece>;

class Improver {
 public:
  Improver(const TriMesh& part, const ImproveTask& task,
           const std::vector<ClearanceNeighbour>& neighbours, const PathOptions& options,
           RunContext& run, PathReport& report)
      : o_(options),
        task_(task),
        run_(run),
        report_(report),
        scene_(part, neighbours, options, run),
        demand_(demandOf(neighbours, options)),
        memory_(scene_.memory()) {}

  void improve() {
    readKeys();
    std::vector<Stretch> now = split(demand_.apart);
    report_.before = figuresOf(now);
    report_.before->clearance = clearanceBefore(now);
    std::vector<Stretch> best = mended(now, demand_.apart);
    Demand demand = demand_;
    auto [rows, clearance] = certify(best, demand);
    if (task_.moreClearance && !rows.empty() && allFreeOrReleased(best)) {
      widenAll(best);
      clearance = certify(best, demand).second;
      raise(best, demand, clearance);
    }
    report_.seconds.push_back({"search", timer_.lap()});
    storeResult(best, demand);
    report_.seconds.push_back({"certify", timer_.lap()});
  }

  double seconds() const { return timer_.seconds(); }

 private:
  void readKeys() {
    const std::vector<Pose>& poses = task_.motion.poses;
    if (poses.size() < 2)
      throw Error(Status::InvalidInput, "BadPose",
                  "the motion has " + counted(std::ssize(poses), "pose") +
                      ", but a path to improve needs at least 2; add poses");
    for (std::size_t i = 0; i < poses.size(); ++i)
      keys_.push_back(scene_.inside(checkedPose(poses[i], keyName(i))));
    for (std::size_t i = 1; i < poses.size(); ++i)
      if (!(poses[i].timeSeconds >= poses[i - 1].timeSeconds))
        throw Error(Status::InvalidInput, "BadPose",
                    "key " + std::to_string(i + 1) + ": time " +
                        numberText(poses[i].timeSeconds, 6) + " s is earlier than " +
                        numberText(poses[i - 1].timeSeconds, 6) +
                        " s, the time of the key before; times must not decrease");
    locked_.assign(keys_.size(), 0);
    locked_.front() = locked_.back() = 1;
    for (const std::size_t i : task_.locked) {
      if (i >= keys_.size())
        throw Error(Status::InvalidInput, "BadOption",
                    "the locked key " + std::to_string(i + 1) + " does not exist; the motion has " +
                        std::to_string(keys_.size()) + " keys");
      locked_[i] = 1;
    }
    space_.upright = keys_.back().pose.rotation;
    space_.largestTurn = o_.translationOnly ? 0 : o_.largestTurn.value_or(4.0);
    Eigen::AlignedBox3d box = scene_.box();
    for (const State& key : keys_) box.extend(key.middle);
    const double most = *std::max_element(demand_.apart.begin(), demand_.apart.end());
    const Eigen::Vector3d margin = Eigen::Vector3d::Constant(1.5 * scene_.radius() + most);
    space_.low = box.min() - margin;
    space_.high = box.max() + margin;
    std::vector<char> closed;
    for (std::size_t i = 0; i < scene_.count(); ++i)
      closed.push_back(scene_.neighbour(i).closed() ? 1 : 0);
    report_.warnings = clearance::openFindings(demand_.names, closed, scene_.part().closed());
  }

  // Splits the motion into pieces that keep the rule and pieces that do not.
  std::vector<Stretch> split(const Rule& rule) {
    std::vector<Stretch> stretches;
    for (std::size_t i = 0; i + 1 < keys_.size(); ++i) {
      run_.checkpoint(Phase::Straight, i, keys_.size());
      if (locked_[i]) stretches.emplace_back();
      splitMove(keys_[i], keys_[i + 1], rule, stretches.back());
    }
    return stretches;
  }

  static void append(Stretch& stretch, const State& from, const State& to, bool free) {
    if (stretch.empty() || stretch.back().free != free) stretch.push_back({{from}, free});
    stretch.back().keys.push_back(to);
  }

  void splitMove(const State& a, const State& b, const Rule& rule, Stretch& stretch) {
    const double ahead = scene_.follow(a, b, rule, memory_).fraction;
    if (ahead >= 1) {
      append(stretch, a, b, true);
      return;
    }
    const double back = scene_.follow(b, a, rule, memory_).fraction;
    const double least =
        kMinPieceLength * scene_.radius() / std::max(scene_.distance(a, b), 1e-300);
    const double first = kGapFraction * ahead > least ? kGapFraction * ahead : 0;
    const double last = kGapFraction * back > least ? 1 - kGapFraction * back : 1;
    // The free parts from both ends overlap, but the whole move is not proven free.
    if (first >= last) {
      append(stretch, a, b, false);
      return;
    }
    const State from = first > 0 ? scene_.stateBetween(a, b, first) : a;
    const State to = last < 1 ? scene_.stateBetween(a, b, last) : b;
    if (first > 0) append(stretch, a, from, true);
    append(stretch, from, to, false);
    if (last < 1) append(stretch, to, b, true);
  }

  // Returns true if the piece lies inside the release zone of an end. There it may be closer to a
  // neighbour than the rule requires.
  bool released(const Piece& piece) const {
    for (const State& end : {keys_.front(), keys_.back()})
      if (std::all_of(piece.keys.begin(), piece.keys.end(), [&](const State& state) {
            return scene_.distance(state, end) <= o_.release;
          }))
        return true;
    return false;
  }

  bool allFreeOrReleased(const std::vector<Stretch>& stretches) const {
    for (const Stretch& stretch : stretches)
      for (const Piece& piece : stretch)
        if (!piece.free && !released(piece)) return false;
    return true;
  }

  // Searches for a new path for each piece that breaks the rule, then shortens the free pieces.
  // With `inTime`, returns no stretches if the time limit is exceeded.
  std::vector<Stretch> mended(const std::vector<Stretch>& before, const Rule& rule,
                              bool inTime = false) {
    std::vector<Stretch> after;
    for (const Stretch& stretch : before) {
      if (inTime && timer_.seconds() > o_.budgetSeconds) return {};
      Stretch whole;
      for (const Piece& piece : stretch) {
        Piece next = piece;
        if (!piece.free && !released(piece)) replacePiece(next, rule);
        for (std::size_t i = 0; i + 1 < next.keys.size(); ++i)
          append(whole, next.keys[i], next.keys[i + 1], next.free);
      }
      for (Piece& piece : whole) {
        if (!piece.free) continue;
        RandomNumbers random(o_.seed + ++shortened_);
        shorten(scene_, rule, turnLimit(scene_, space_), kShortcuts, random, piece.keys, run_);
      }
      after.push_back(std::move(whole));
    }
    return after;
  }

  void replacePiece(Piece& piece, const Rule& rule) {
    if (timer_.seconds() > o_.budgetSeconds || !scene_.isFree(piece.keys.front(), rule, memory_) ||
        !scene_.isFree(piece.keys.back(), rule, memory_))
      return;
    Leg leg;
    leg.starts = {piece.keys.front()};
    leg.goals = {piece.keys.back()};
    leg.space = space_;
    leg.far = (space_.high - space_.low).norm();
    const double until =
        std::min(o_.budgetSeconds, timer_.seconds() + kBudgetFraction * o_.budgetSeconds);
    const Limits limits{timer_, until, o_.seed, nullptr, o_.mostSteps};
    const LegResult found = solveLeg(scene_, rule, leg, limits, run_);
    report_.steps += found.steps;
    if (found.keys.empty()) return;
    piece = {found.keys, true};
  }

  void widenAll(std::vector<Stretch>& stretches) {
    const WidenLimits limits{turnLimit(scene_, space_), space_.turns(),
                             [this] { return timer_.seconds() > o_.budgetSeconds; }};
    for (Stretch& stretch : stretches)
      for (Piece& piece : stretch) {
        if (!piece.free) continue;
        RandomNumbers random(o_.seed + ++shortened_);
        widen(scene_, demand_.apart, limits, random, piece.keys, run_);
      }
  }

  // Raises the clearance step by step. Each step starts from the given motion, and is accepted only
  // if the whole result outside the release zones keeps the raised clearance.
  void raise(std::vector<Stretch>& best, Demand& demand, double clearance) {
    double reached = std::max(clearance, demand_.tolerance), step = kRaise;
    while (step > kMinRaise && timer_.seconds() < o_.budgetSeconds) {
      Demand higher = demand_;
      for (std::size_t k = 0; k < scene_.count(); ++k) {
        const double more = step * reached - std::max(higher.required[k], higher.tolerance);
        if (more <= 0) continue;
        higher.required[k] = step * reached;
        higher.apart[k] += more;
      }
      const std::vector<Stretch> next = mended(split(higher.apart), higher.apart, true);
      if (next.empty()) return;
      const bool allowed = allFreeOrReleased(next);
      const auto [rows, now] = allowed ? certify(next, higher) : decltype(certify(next, higher)){};
      if (rows.empty()) {
        step = std::sqrt(step);
        continue;
      }
      best = next;
      demand = higher;
      reached = std::max(step * reached, now);
    }
  }

  PathFigures figuresOf(const std::vector<Stretch>& stretches) const {
    PathFigures figures;
    figures.keys = std::ssize(keys_);
    for (const Stretch& stretch : stretches)
      for (const Piece& piece : stretch)
        for (std::size_t i = 1; i < piece.keys.size(); ++i) {
          const State &a = piece.keys[i - 1], &b = piece.keys[i];
          figures.length += (b.middle - a.middle).norm();
          figures.turn += a.pose.rotation.angularDistance(b.pose.rotation);
        }
    return figures;
  }

  std::vector<NeighbourClearance> rowsOf(const Piece& piece, const Demand& demand) {
    Trajectory motion{{}, o_.interpolation};
    for (std::size_t i = 0; i < piece.keys.size(); ++i) {
      motion.poses.push_back(piece.keys[i].pose);
      motion.poses.back().timeSeconds = static_cast<double>(i);
    }
    return certificateOf(scene_, demand, motion, Rule(scene_.count(), 0), run_);
  }

  // Checks all free pieces with certificateOf(). Returns for each neighbour the row with the
  // smallest distance, and the smallest clearance of all. Without free pieces there are no rows.
  std::pair<std::vector<NeighbourClearance>, double> certify(const std::vector<Stretch>& stretches,
                                                             const Demand& demand) {
    std::vector<NeighbourClearance> nearest;
    for (const Stretch& stretch : stretches)
      for (const Piece& piece : stretch) {
        if (!piece.free) continue;
        const std::vector<NeighbourClearance> rows = rowsOf(piece, demand);
        for (const NeighbourClearance& row : rows)
          if (row.verdict != ClearanceVerdict::Clear)
            throw Error(
                Status::InternalError, "NotCertified",
                "the search found a section of the path to be free, but the final check did "
                "not confirm that it is clear" +
                    faultText("the parts and the motion"));
        if (nearest.empty()) nearest = rows;
        for (std::size_t i = 0; i < rows.size(); ++i)
          if (rows[i].guaranteed < nearest[i].guaranteed) nearest[i] = rows[i];
      }
    if (nearest.empty()) return {nearest, 0};
    return {nearest, provenClearance(nearest, demand)};
  }

  // Returns the smallest clearance of the given motion outside the release zones.
  double clearanceBefore(const std::vector<Stretch>& stretches) {
    const auto [rows, free] = certify(stretches, demand_);
    double smallest = free;
    bool known = !rows.empty();
    for (const Stretch& stretch : stretches)
      for (const Piece& piece : stretch) {
        if (piece.free || released(piece)) continue;
        const double near = smallestGuaranteed(rowsOf(piece, demand_));
        smallest = known ? std::min(smallest, near) : near;
        known = true;
      }
    return smallest;
  }

  // Locked keys keep their times. Between them, the times of other keys are proportional to the
  // path length.
  void storeResult(const std::vector<Stretch>& stretches, const Demand& demand) {
    auto [rows, clearance] = certify(stretches, demand);
    report_.certificate = std::move(rows);
    report_.clearance = clearance;
    report_.budgetEnded = timer_.seconds() > o_.budgetSeconds;
    if (report_.certificate.empty()) {
      report_.escape.pose = task_.motion.poses.back();
      const double most = *std::max_element(demand.required.begin(), demand.required.end());
      report_.summary = "no section of the motion keeps the required distance (" +
                        numberText(std::max(most, demand.tolerance), 6) +
                        " mm); move its keys away from the neighbours" +
                        (most > demand.tolerance ? ", or reduce this distance" : "");
      return;
    }
    report_.verdict = PathVerdict::Found;
    report_.method = "improved";
    report_.path.interpolation = o_.interpolation;
    std::size_t first = 0;
    for (const Stretch& stretch : stretches) {
      std::size_t last = first + 1;
      while (!locked_[last]) ++last;
      storeStretch(stretch, task_.motion.poses[first], task_.motion.poses[last]);
      first = last;
    }
    const PathFigures figures = figuresOf(stretches);
    report_.length = figures.length;
    report_.turn = figures.turn;
    report_.summary = figuresText(report_) + "; " + std::to_string(report_.keptMoves) +
                      " sections left unchanged";
  }

  void storeStretch(const Stretch& stretch, const Pose& from, const Pose& to) {
    std::vector<State> keys{stretch.front().keys.front()};
    for (const Piece& piece : stretch) {
      keys.insert(keys.end(), piece.keys.begin() + 1, piece.keys.end());
      if (piece.free) continue;
      report_.keptMoves += std::ssize(piece.keys) - 1;
      if (!released(piece)) report_.unmendedMoves += std::ssize(piece.keys) - 1;
    }
    const double whole = std::max(lengthOf(scene_, keys), 1e-300);
    double travelled = 0;
    for (std::size_t i = 0; i < keys.size(); ++i) {
      if (i > 0) travelled += scene_.distance(keys[i - 1], keys[i]);
      Pose pose = scene_.outside(keys[i]);
      pose.timeSeconds = from.timeSeconds + (to.timeSeconds - from.timeSeconds) * travelled / whole;
      if (i == 0 || i + 1 == keys.size()) pose = i == 0 ? from : to;
      if (i > 0 || report_.path.poses.empty()) report_.path.poses.push_back(pose);
    }
  }

  const PathOptions& o_;
  const ImproveTask& task_;
  RunContext& run_;
  PathReport& report_;
  Timer timer_;
  Scene scene_;
  Demand demand_;
  Memory memory_;
  SearchSpace space_;
  std::vector<State> keys_;
  std::vector<char> locked_;
  std::uint64_t shortened_ = 0;
};

}  // namespace

PathReport improvePath(const TriMesh& part, const ImproveTask& task,
                       const std::vector<ClearanceNeighbour>& neighbours,
                       const PathOptions& options, RunContext& run) {
  PathOptions o = options;
  o.interpolation = task.motion.interpolation;
  return guardedPath(part, neighbours, o, run, [&](PathReport& report, const auto& counted) {
    PathTask ends;
    ends.start = Pose{};
    checkPathOptions(ends, counted, o);
    for (std::size_t i = 0; i < task.motion.poses.size(); ++i)
      checkedPose(task.motion.poses[i], keyName(i));
    // The pivot moves along straight lines. All computations use coordinates whose origin is the
    // pivot.
    const Eigen::Vector3d pivot = pivotOf(task.motion);
    const ImproveTask carried{carriedByPivot(task.motion, pivot), task.locked, task.moreClearance};
    Improver improver(seenFromPivot(part, pivot), carried, counted, o, run, report);
    improver.improve();
    for (Pose& pose : report.path.poses) pose = backFromPivot(pose, pivot);
    report.path.pivot = pivot;
    return improver.seconds();
  });
}

}  // namespace swept
