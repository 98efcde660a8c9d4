// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/sweep/contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace swept::step {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kRounds = 30;
constexpr double kNoContact = std::numeric_limits<double>::quiet_NaN();
/// Sine of 3 degrees: the smallest angle at which rails must cross the contact curve.
constexpr double kMinCrossing = 0.05;

// Returns the position of x in the range, in units of node intervals.
double gridPosition(Range range, double x, int nodes) {
  return range.length() > 0 ? std::clamp((x - range.from) / range.length(), 0.0, 1.0) * nodes : 0;
}

bool isIn(Range range, double x) {
  const double slack = 1e-9 * range.length();
  return x >= range.from - slack && x <= range.to + slack;
}

}  // namespace

Moment::Moment(const StepPath& path, double s) : placement(path.at(s)) {
  const Twist twist = path.twistAt(path.poseAt(s));
  const Eigen::Matrix3d back = placement.rotation.transpose();
  linear = back * (twist.linear + twist.angular.cross(placement.translation));
  angular = back * twist.angular;
}

double ContactMap::speed(double w, double v, const Moment& moment) const {
  const Rails::Point point = rails_.at(w, v);
  return point.normal.dot(moment.velocityAt(point.at));
}

// Returns the length on the face per unit of one of its parameters.
double ContactMap::lengthPer(double w, double v, bool alongRail) const {
  constexpr double kStep = 1e-4;
  const Vector3d a = alongRail ? rails_.at(w, v - kStep).at : rails_.at(w - kStep, v).at;
  const Vector3d b = alongRail ? rails_.at(w, v + kStep).at : rails_.at(w + kStep, v).at;
  return (b - a).norm() / (2 * kStep);
}

Vector2d ContactMap::slopes(double w, double v, const Moment& moment) const {
  const double perV = lengthPer(w, v, true), perW = lengthPer(w, v, false);
  if (!(perV > 0 && perW > 0)) return Vector2d::Zero();
  const double hv = 1e-5 * size_ / perV, hw = 1e-5 * size_ / perW;
  return {(speed(w, v + hv, moment) - speed(w, v - hv, moment)) / (2 * hv * perV),
          (speed(w + hw, v, moment) - speed(w - hw, v, moment)) / (2 * hw * perW)};
}

std::optional<double> ContactMap::solve(double w, double v, const Moment& moment) const {
  double perV = lengthPer(w, v, true);
  if (!(perV > 0)) return std::nullopt;
  double last = 1e300;
  for (int round = 0; round < kRounds; ++round) {
    const double h = 1e-5 * size_ / perV;
    const double value = speed(w, v, moment);
    const double slope = (speed(w, v + h, moment) - speed(w, v - h, moment)) / (2 * h);
    if (!std::isfinite(value) || slope == 0) return std::nullopt;
    // A step is at most a quarter of the size.
    const double most = 0.25 * size_ / perV;
    const double step = std::clamp(value / slope, -most, most);
    v -= step;
    const double moved = std::abs(step) * perV;
    if (moved < 1e-13 * size_) return v;
    // If so, rounding prevents smaller steps.
    if (moved < 1e-9 * size_ && moved >= 0.5 * last) return v;
    last = moved;
  }
  return std::nullopt;
}

Degeneracy ContactMap::follow(Range w, Range s, Range innerW, Range innerS, const Vector3d& start,
                              Vector2d& where) {
  w_ = w;
  s_ = s;
  parameters_.assign((kNodes + 1) * (kNodes + 1), kNoContact);
  const int firstW = static_cast<int>(std::lround(gridPosition(w, start.x(), kNodes)));
  const int firstS = static_cast<int>(std::lround(gridPosition(s, start.z(), kNodes)));
  std::vector<Moment> moments;
  for (int j = 0; j <= kNodes; ++j) moments.emplace_back(path_, s.at(j / double{kNodes}));
  // Follows the contact over time on the first rail, then from rail to rail at each time.
  const auto visit = [&](int i, int j, double from) {
    const double rail = w.at(i / double{kNodes}), at = s.at(j / double{kNodes});
    const auto found = solve(rail, from, moments[j]);
    if (found) node(i, j) = *found;
    if (!isIn(innerW, rail) || !isIn(innerS, at)) return Degeneracy::None;
    where = {rail, at};
    if (!found) return Degeneracy::NoContact;
    if (!rails_.covers(rail, *found)) return Degeneracy::LeavesFace;
    const Vector2d slope = slopes(rail, *found, moments[j]);
    return std::abs(slope.x()) > kMinCrossing * slope.norm() ? Degeneracy::None : Degeneracy::Fold;
  };
  const auto sweep = [&](bool alongTime, int fixed, int first) {
    for (const int direction : {-1, 1}) {
      for (int k = first + direction; k >= 0 && k <= kNodes; k += direction) {
        const int i = alongTime ? fixed : k, j = alongTime ? k : fixed;
        const double before = alongTime ? node(i, j - direction) : node(i - direction, j);
        const Degeneracy why = visit(i, j, before);
        if (why != Degeneracy::None) return why;
      }
    }
    return Degeneracy::None;
  };
  Degeneracy why = visit(firstW, firstS, start.y());
  if (why == Degeneracy::None) why = sweep(true, firstW, firstS);
  for (int j = 0; j <= kNodes && why == Degeneracy::None; ++j) why = sweep(false, j, firstW);
  return why;
}

double ContactMap::parameterAt(double w, double s) const {
  const double x = gridPosition(w_, w, kNodes), y = gridPosition(s_, s, kNodes);
  const int i = std::min(kNodes - 1, static_cast<int>(x));
  const int j = std::min(kNodes - 1, static_cast<int>(y));
  const double a = x - i, b = y - j;
  const double guess = (1 - a) * ((1 - b) * node(i, j) + b * node(i, j + 1)) +
                       a * ((1 - b) * node(i + 1, j) + b * node(i + 1, j + 1));
  const auto found = solve(w, guess, Moment(path_, s));
  return found ? *found : kNoContact;
}

}  // namespace swept::step
