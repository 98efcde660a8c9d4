// SPDX-License-Identifier: LGPL-2.1-or-later
#include "path/straight_moves.h"

#include "path/contacts.h"

namespace swept::path {
namespace {

// A straight shift from a placement. The next move may start at its end or its middle.
struct Ray {
  State from, to;
};

std::vector<Ray> raysFrom(const Scene& scene, const Rule& rule, const std::vector<State>& states,
                          double far, Memory& memory, const std::function<bool()>& isLate,
                          RunContext& run) {
  std::vector<Ray> rays;
  Rule near = rule;
  for (double& apart : near) apart = apart < 0 ? apart : apart + 0.05 * scene.radius();
  for (const State& state : states) {
    for (const Twist& move : freeMoves(scene, state, contactsOf(scene, state, near), false)) {
      if (isLate()) return rays;
      run.checkpoint(Phase::Straight);
      const State end = scene.moved(state, move * far);
      const double fraction = scene.follow(state, end, rule, memory).fraction;
      if (fraction * far < 0.02 * scene.radius()) continue;
      for (const double part : {1.0, 0.5})
        rays.push_back({state, scene.moved(state, move * (part * fraction * far))});
    }
  }
  return rays;
}

}  // namespace

std::vector<State> straightMoves(const Scene& scene, const Rule& rule, const MoveAllowed& allowed,
                                 const std::vector<State>& starts, const std::vector<State>& goals,
                                 double far, Memory& memory, const std::function<bool()>& isLate,
                                 RunContext& run) {
  const auto isFree = [&](const State& a, const State& b) {
    run.checkpoint(Phase::Straight);
    return !isLate() && allowed(a, b) && scene.follow(a, b, rule, memory).fraction >= 1;
  };
  for (const State& start : starts)
    for (const State& goal : goals)
      if (isFree(start, goal)) return {start, goal};
  const std::vector<Ray> fromGoal = raysFrom(scene, rule, goals, far, memory, isLate, run);
  for (const Ray& ray : fromGoal)
    for (const State& start : starts)
      if (isFree(start, ray.to) && isFree(ray.to, ray.from)) return {start, ray.to, ray.from};
  const std::vector<Ray> fromStart = raysFrom(scene, rule, starts, far, memory, isLate, run);
  for (const Ray& ray : fromStart)
    for (const State& goal : goals)
      if (isFree(ray.to, goal) && isFree(ray.from, ray.to)) return {ray.from, ray.to, goal};
  for (const Ray& a : fromStart)
    for (const Ray& b : fromGoal)
      if (isFree(a.to, b.to) && isFree(a.from, a.to) && isFree(b.to, b.from))
        return {a.from, a.to, b.to, b.from};
  return {};
}

}  // namespace swept::path
