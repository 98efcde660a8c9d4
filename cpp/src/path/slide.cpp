// SPDX-License-Identifier: LGPL-2.1-or-later
#include "path/slide.h"

#include <algorithm>
#include <cmath>

namespace swept::path {
namespace {

using Vector6d = Eigen::Matrix<double, 6, 1>;

constexpr std::size_t kMaxTouches = 12;
// Distance kept from contacts if there is room, in radii of the part.
constexpr double kSlideMargin = 2e-3;
constexpr int kSlideRounds = 40;

/// Linear inequality for a move v: row . v >= least. size: row . row; weight: multiple of `row`
/// that nearest() has added to v.
struct Limit {
  Vector6d row = Vector6d::Zero();
  double least = 0, size = 0, weight = 0;
};

// Changes v to the nearest move that satisfies all limits. Returns false if the iteration does not
// converge.
bool nearest(std::vector<Limit>& limits, double tolerance, Vector6d& v) {
  for (Limit& limit : limits) limit.weight = 0;
  for (int round = 0; round < kSlideRounds; ++round) {
    double worst = 0;
    for (Limit& limit : limits) {
      const double missing = limit.least - limit.row.dot(v);
      const double weight = std::max(0.0, limit.weight + missing / limit.size);
      const double change = weight - limit.weight;
      if (change == 0) continue;
      limit.weight = weight;
      v += change * limit.row;
      worst = std::max(worst, std::abs(change) * limit.size);
    }
    if (worst <= tolerance) return true;
  }
  return false;
}

}  // namespace

bool addTouch(const Memory& memory, int neighbour, Touches& touches) {
  const Touch touch{neighbour, memory.pairs[static_cast<std::size_t>(neighbour)]};
  if (touch.pair.body < 0) return false;
  if (std::find(touches.begin(), touches.end(), touch) != touches.end()) return false;
  if (touches.size() >= kMaxTouches) touches.erase(touches.begin());
  touches.push_back(touch);
  return true;
}

void dropFar(const Scene& scene, const State& state, const Rule& rule, double reach,
             Touches& touches) {
  const Eigen::Matrix3d R = state.pose.rotation.toRotationMatrix();
  std::erase_if(touches, [&](const Touch& touch) {
    const auto i = static_cast<std::size_t>(touch.neighbour);
    const double far = rule[i] + reach;
    const clearance::PairSearch pair(scene.part(), scene.neighbour(i));
    return pair.leafDistance(R, state.pose.translation, touch.pair).squared > far * far;
  });
}

Twist allowedMove(const Scene& scene, const State& state, const Rule& rule, const Touches& touches,
                  const Twist& wanted) {
  if (touches.empty()) return wanted;
  const double radius = scene.radius(), length = scene.length(wanted);
  const Eigen::Matrix3d R = state.pose.rotation.toRotationMatrix();
  std::vector<Limit> limits;
  for (const Touch& touch : touches) {
    const auto i = static_cast<std::size_t>(touch.neighbour);
    const clearance::PairSearch pair(scene.part(), scene.neighbour(i));
    const NearestPoints near = pair.leafDistance(R, state.pose.translation, touch.pair);
    const double distance = std::sqrt(near.squared);
    if (!(distance > 0) || distance > rule[i] + length) continue;
    const Eigen::Vector3d normal = (near.a - near.b) / distance;
    Limit limit;
    limit.row << normal, (near.a - state.middle).cross(normal) / radius;
    limit.size = limit.row.squaredNorm();
    limit.least = rule[i] - distance;
    limits.push_back(limit);
  }
  Vector6d start;
  start << wanted.shift, wanted.turn * radius;
  const double tolerance = 1e-3 * length;
  const double margin = std::min(kSlideMargin * radius, 0.1 * length);
  if (std::all_of(limits.begin(), limits.end(),
                  [&](const Limit& limit) { return limit.row.dot(start) >= limit.least + margin; }))
    return wanted;
  Vector6d v = start;
  for (Limit& limit : limits) limit.least += margin;
  if (!nearest(limits, std::min(tolerance, 0.5 * margin), v)) {
    // There is no room for the margin. Without it, some move satisfies all limits, at worst that of
    // length 0.
    for (Limit& limit : limits) limit.least = std::min(0.0, limit.least - margin);
    v = start;
    nearest(limits, tolerance, v);
  }
  return {v.head<3>(), v.tail<3>() / radius};
}

}  // namespace swept::path
