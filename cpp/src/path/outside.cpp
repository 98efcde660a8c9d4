// SPDX-License-Identifier: LGPL-2.1-or-later
#include "path/outside.h"

#include <algorithm>

namespace swept::path {
namespace {

using Eigen::Vector3d;

double largest(const Rule& rule) { return *std::max_element(rule.begin(), rule.end()); }

// Returns how far (mm) the part extends from its middle in the direction -d, in its orientation at
// `state`.
double reachBack(const Scene& scene, const State& state, const Vector3d& d) {
  const Vector3d local = state.pose.rotation.conjugate() * d;
  double reach = 0;
  const Vector3d middle = state.pose.rotation.conjugate() * (state.middle - state.pose.translation);
  for (std::uint32_t place = 0; place < scene.part().tree().size(); ++place)
    for (const Vector3d& x : scene.part().corners(place))
      reach = std::max(reach, local.dot(middle - x));
  return reach;
}

// Returns how far the box of the neighbours extends along d.
double front(const Scene& scene, const Vector3d& d) {
  const Vector3d half = 0.5 * scene.box().sizes();
  return d.dot(scene.box().center()) + d.cwiseAbs().dot(half);
}

}  // namespace

End outside(const Scene& scene, const Demand& demand, const State& goal,
            const Extraction& extraction) {
  End end{goal, Rule(scene.count(), -1), {}};
  Memory memory = scene.memory();
  const auto tryShift = [&](const Vector3d& shift) {
    const State state = scene.moved(goal, {shift, Vector3d::Zero()});
    if (scene.isFree(state, demand.apart, memory)) end.exits.push_back({state});
  };
  if (extraction.direction) {
    const Vector3d d = extraction.direction->normalized();
    const double distance =
        front(scene, d) + reachBack(scene, goal, d) + largest(demand.apart) - d.dot(goal.middle);
    tryShift(std::max(1.001 * distance, 1e-3 * scene.radius()) * d);
    return end;
  }
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z)
        if (x != 0 || y != 0 || z != 0)
          tryShift(1.001 * extraction.radius * Vector3d(x, y, z).normalized());
  return end;
}

std::function<bool(const State&)> outsideTest(const Scene& scene, const Demand& demand,
                                              const State& goal, const Extraction& extraction) {
  if (!extraction.direction)
    return [middle = goal.middle, radius = extraction.radius](const State& state) {
      return (state.middle - middle).norm() >= radius;
    };
  const Vector3d d = extraction.direction->normalized();
  const double line = front(scene, d) + largest(demand.apart);
  return [&scene, d, line](const State& state) {
    return d.dot(state.middle) - scene.radius() >= line ||
           (d.dot(state.middle) >= line &&
            d.dot(state.middle) - reachBack(scene, state, d) >= line);
  };
}

}  // namespace swept::path
