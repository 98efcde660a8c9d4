// SPDX-License-Identifier: LGPL-2.1-or-later
#include "path/ladder.h"

#include <algorithm>
#include <deque>
#include <memory>
#include <numbers>

#include "base/parallel.h"
#include "path/shifts.h"
#include "path/straight_moves.h"

namespace swept::path {
namespace {

// Number of parallel searches. They differ in their random numbers. The first path found wins.
constexpr std::size_t kSearches = 2;
constexpr int kRoundsPerTurn = 20;  // rounds of one search before all searches are compared
// A search restarts for the first time when its two trees together have this many nodes.
constexpr std::size_t kNodesAtFirst = 3000;
constexpr std::size_t kMaxStarts = 8;  // with more starts, no grids are searched
constexpr int kGridPlacements = 8000, kProofPlacements = 6000;  // placements tried on one grid
constexpr const char* kGridMethod = "grid of places";
// Placements tried on grids before the searches in six dimensions begin, and in each of their
// rounds.
constexpr int kFirstPlacements = 1000, kRoundPlacements = 10;

// One search in six dimensions. If its trees have grown too large, it restarts with other random
// numbers.
class Search {
 public:
  Search(const Scene& scene, const Rule& rule, const Leg& leg, std::uint64_t seed)
      : scene_(scene), rule_(rule), leg_(leg), seed_(seed) {
    begin();
  }

  bool round() {
    if (trees_->grow(1)) return true;
    if (trees_->nodes() <= most_) return false;
    steps_ += trees_->steps();
    most_ += most_ / 4;
    begin();
    return false;
  }
  const TwoTrees& trees() const { return *trees_; }
  std::int64_t steps() const { return steps_ + trees_->steps(); }

 private:
  void begin() {
    trees_ = std::make_unique<TwoTrees>(scene_, rule_, leg_.space, leg_.starts, leg_.goals,
                                        seed_ + 7919 * ++begun_);
  }

  const Scene& scene_;
  const Rule& rule_;
  const Leg& leg_;
  std::uint64_t seed_, begun_ = 0;
  std::size_t most_ = kNodesAtFirst;
  std::int64_t steps_ = 0;
  std::unique_ptr<TwoTrees> trees_;
};

class SixDimensions {
 public:
  /// `shifts`: a search over grids that continues in parallel to the searches in six dimensions.
  SixDimensions(const Scene& scene, const Rule& rule, const Leg& leg, const Limits& limits,
                ShiftSearch& shifts, RunContext& run)
      : scene_(scene), leg_(leg), limits_(limits), shifts_(shifts), run_(run) {
    for (std::size_t i = 0; i < kSearches; ++i)
      searches_.emplace_back(scene, rule, leg, limits.seed * 1000003 + i * 65537);
  }

  LegResult search() {
    LegResult result;
    result.farthest = shifts_.farthest();
    std::vector<char> done(kSearches, 0);
    while (!limits_.over() && !(stepsOver() && shifts_.isOver()) && result.keys.empty() &&
           shifts_.path().empty()) {
      const bool turning = !stepsOver();
      parallelFor(kSearches + 1, [&](std::size_t i) {
        if (i == kSearches) return shifts_.advance(kRoundPlacements, run_);
        for (int k = 0; k < kRoundsPerTurn && turning && !done[i] && !run_.isCancelled(); ++k) {
          if (limits_.over()) break;
          done[i] = searches_[i].round() ? 1 : 0;
        }
      });
      run_.checkpoint(Phase::Turns, static_cast<std::uint64_t>(1000 * limits_.timer.seconds()),
                      static_cast<std::uint64_t>(1000 * limits_.seconds) + 1);
      for (std::size_t i = 0; i < kSearches; ++i) {
        note(searches_[i], result);
        if (done[i] && result.keys.empty()) result.keys = searches_[i].trees().path();
      }
      if (limits_.watch != nullptr) limits_.watch->show(scene_.outside(result.farthest));
    }
    result.method = leg_.space.turns() ? "six dimensions" : "no turning";
    if (result.keys.empty() && !shifts_.path().empty()) {
      result.keys = shifts_.path();
      result.method = kGridMethod;
    }
    result.blocked.assign(scene_.count(), 0);
    for (const Search& search : searches_) {
      result.steps += search.steps();
      for (std::size_t i = 0; i < scene_.count(); ++i)
        result.blocked[i] += search.trees().blocked()[i];
    }
    return result;
  }

 private:
  // Call this only between rounds, so that the result does not depend on the number of threads.
  bool stepsOver() const {
    if (!limits_.mostSteps) return false;
    std::int64_t steps = 0;
    for (const Search& search : searches_) steps += search.steps();
    return steps >= *limits_.mostSteps;
  }
  void note(const Search& search, LegResult& result) const {
    const Eigen::Vector3d& root = leg_.goals.front().middle;
    const State& state = search.trees().farthest();
    if ((state.middle - root).norm() > (result.farthest.middle - root).norm())
      result.farthest = state;
  }

  const Scene& scene_;
  const Leg& leg_;
  const Limits& limits_;
  ShiftSearch& shifts_;
  RunContext& run_;
  std::deque<Search> searches_;
};

}  // namespace

MoveAllowed turnLimit(const Scene& scene, const SearchSpace& space) {
  return [&scene, &space](const State& a, const State& b) {
    if (!space.turns()) return a.pose.rotation.angularDistance(b.pose.rotation) < 1e-9;
    if (space.largestTurn >= std::numbers::pi) return true;
    // Rotations of less than 90 degrees about one centre form a convex set. For a larger limit,
    // placements in between must be tested, too.
    const int pieces = space.largestTurn <= std::numbers::pi / 2 ? 1 : 32;
    for (int k = 0; k <= pieces; ++k) {
      const State at = k == 0 ? a : k == pieces ? b : scene.stateBetween(a, b, double(k) / pieces);
      if (at.pose.rotation.angularDistance(space.upright) > space.largestTurn) return false;
    }
    return true;
  };
}

LegResult solveLeg(const Scene& scene, const Rule& rule, const Leg& leg, const Limits& limits,
                   RunContext& run) {
  LegResult result;
  Memory memory = scene.memory();
  const MoveAllowed allowed = turnLimit(scene, leg.space);
  const auto isLate = [&limits] { return limits.over(); };
  result.keys =
      straightMoves(scene, rule, allowed, leg.starts, leg.goals, leg.far, memory, isLate, run);
  if (!result.keys.empty()) {
    result.method = result.keys.size() == 2 ? "straight" : "straight moves";
    result.steps = memory.steps;
    return result;
  }
  // The grid search keeps the orientation of the goal. It links starts with other orientations to a
  // placement with that orientation. If the part may not turn, the whole grids are searched first,
  // because they may prove that there is no path.
  std::vector<State> starts;
  for (const State& state : leg.starts)
    if (leg.starts.size() <= kMaxStarts && allowed(state, leg.goals.front()))
      starts.push_back(state);
  const auto pairs = static_cast<int>(leg.starts.size() * leg.goals.size());
  ShiftSearch shifts(scene, rule, leg.space, starts, leg.goals,
                     std::max(kGridPlacements / 10, kGridPlacements / std::max(1, pairs)));
  for (int placements = 0; !shifts.isOver() && !limits.over(); placements += kRoundPlacements) {
    if (leg.space.turns() && placements >= kFirstPlacements) break;
    run.checkpoint(Phase::Shifts);
    shifts.advance(kRoundPlacements, run);
  }
  const State* start = leg.space.isOut || leg.starts.empty() ? nullptr : &leg.starts.front();
  const bool proven = shifts.path().empty() && leg.provable && !leg.space.turns() &&
                      provesNoTranslation(scene, rule, leg.space, start, leg.goals.front(),
                                          kProofPlacements, isLate, run);
  if (!shifts.path().empty()) {
    result.keys = shifts.path();
    result.method = kGridMethod;
  } else if (proven) {
    result.farthest = shifts.farthest();
  } else {
    result = SixDimensions(scene, rule, leg, limits, shifts, run).search();
  }
  result.noTranslation = proven;
  result.blocked.resize(scene.count(), 0);
  for (const Memory& used : {memory, shifts.memory()}) {
    for (std::size_t i = 0; i < scene.count(); ++i) result.blocked[i] += used.blocked[i];
    result.steps += used.steps;
  }
  return result;
}

}  // namespace swept::path
