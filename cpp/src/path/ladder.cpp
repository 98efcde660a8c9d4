// SPDX-License-Identifier: LGPL-2.1-or-later
#include "path/ladder.h"

#include <algorithm>
#include <memory>
#include <numbers>

#include "base/parallel.h"
#include "path/straight_moves.h"

namespace swept::path {
namespace {

// Searches side by side, for as many threads; luck differs, and the first one counts.
constexpr std::size_t kSearches = 2;
constexpr int kRounds = 50;                  // of one search before the others are asked
constexpr std::size_t kNodesAtFirst = 4000;  // of both trees, before a search begins anew

class SixDimensions {
 public:
  SixDimensions(const Scene& scene, const Rule& rule, const Leg& leg, const Limits& limits,
                RunContext& run)
      : scene_(scene), rule_(rule), leg_(leg), limits_(limits), run_(run) {}

  LegResult search() {
    LegResult result;
    result.blocked.assign(scene_.count(), 0);
    result.farthest = leg_.goals.front();
    searches_.resize(kSearches);
    most_.assign(kSearches, kNodesAtFirst);
    while (!limits_.over()) {
      parallelFor(kSearches, [&](std::size_t i) { turn(i); });
      run_.checkpoint(Phase::Turns, static_cast<std::uint64_t>(1000 * limits_.timer.seconds()),
                      static_cast<std::uint64_t>(1000 * limits_.seconds) + 1);
      for (std::size_t i = 0; i < kSearches; ++i) {
        note(*searches_[i], result);
        if (searches_[i]->path().empty()) continue;
        result.keys = searches_[i]->path();
        result.method = leg_.space.turns() ? "six dimensions" : "no turning";
        break;
      }
      if (limits_.watch != nullptr) limits_.watch->show(result.farthest.pose);
      if (!result.keys.empty()) break;
    }
    for (const auto& search : searches_) {
      if (!search) continue;
      result.steps += search->steps();
      for (std::size_t i = 0; i < scene_.count(); ++i) result.blocked[i] += search->blocked()[i];
    }
    result.steps += earlier_;
    return result;
  }

 private:
  void turn(std::size_t i) {
    if (searches_[i] && searches_[i]->nodes() > most_[i]) {
      earlier_ += searches_[i]->steps();
      most_[i] += most_[i] / 2;
      searches_[i].reset();
    }
    if (!searches_[i])
      searches_[i] = std::make_unique<TwoTrees>(scene_, rule_, leg_.space, leg_.starts, leg_.goals,
                                                limits_.seed * 1000003 + most_[i] * kSearches + i);
    for (int k = 0; k < kRounds && !run_.isCancelled() && !limits_.over(); ++k)
      if (searches_[i]->grow(1)) break;
  }

  void note(const TwoTrees& search, LegResult& result) const {
    const Eigen::Vector3d& root = leg_.goals.front().middle;
    if ((search.farthest().middle - root).norm() > (result.farthest.middle - root).norm())
      result.farthest = search.farthest();
  }

  const Scene& scene_;
  const Rule& rule_;
  const Leg& leg_;
  const Limits& limits_;
  RunContext& run_;
  std::vector<std::unique_ptr<TwoTrees>> searches_;
  std::vector<std::size_t> most_;
  std::atomic<std::int64_t> earlier_{0};
};

}  // namespace

MoveAllowed turnLimit(const Scene& scene, const SearchSpace& space) {
  return [&scene, &space](const State& a, const State& b) {
    if (!space.turns()) return a.pose.rotation.angularDistance(b.pose.rotation) < 1e-9;
    if (space.largestTurn >= std::numbers::pi) return true;
    // Turns of less than a quarter about one centre are a convex set; beyond, some places between
    // have to be looked at.
    const int pieces = space.largestTurn <= std::numbers::pi / 2 ? 1 : 32;
    for (int k = 0; k <= pieces; ++k) {
      const State at = k == 0 ? a : k == pieces ? b : scene.onWay(a, b, double(k) / pieces);
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
  result.keys = straightMoves(scene, rule, allowed, leg.starts, leg.goals, leg.far, memory, run);
  if (!result.keys.empty()) {
    result.method = result.keys.size() == 2 ? "straight" : "straight moves";
    result.steps = memory.steps;
    return result;
  }
  result = SixDimensions(scene, rule, leg, limits, run).search();
  result.steps += memory.steps;
  return result;
}

}  // namespace swept::path
