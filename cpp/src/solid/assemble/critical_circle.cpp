// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/critical_circle.h"

#include <algorithm>
#include <cmath>

#include "solid/assemble/zero_curves.h"
#include "solid/sweep/central_difference.h"

namespace swept::step {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

Vector2d byTimeAt(const Pipe& pipe, const StepPath& path, double x, double s) {
  constexpr double kTimeStep = 1e-4;  // of s
  return centralDifference([&](double off) { return pipe.speeds(x, Moment(path, s + off)); },
                           kTimeStep);
}

double crossOf(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

struct Zero {
  double x, s;
};

// Returns the positions and times at which both speeds are zero. The first speed is zero at one
// position on a cylinder, at two on a torus; the second is followed there over time.
std::vector<Zero> zerosOn(const Pipe& pipe, const StepPath& path, Range within) {
  std::vector<Zero> zeros;
  const int branches = pipe.isCylinder() ? 1 : 2;
  for (int branch = 0; branch < branches; ++branch) {
    const auto positionAt = [&](const Moment& moment) {
      const Vector2d at0 = pipe.speeds(0, moment);
      if (pipe.isCylinder()) {
        const Vector2d change = pipe.speedChanges(0, moment);
        return -at0.dot(change) / change.squaredNorm();
      }
      const double atQuarter = pipe.speeds(M_PI / 2, moment).x();
      return std::atan2(at0.x(), -atQuarter) + branch * M_PI;
    };
    const auto speedAt = [&](double s) {
      const Moment moment(path, s);
      const double x = positionAt(moment);
      const Vector2d speeds = pipe.speeds(x, moment);
      return pipe.isCylinder() ? crossOf(pipe.speedChanges(x, moment), speeds) : speeds.y();
    };
    for (const double s : zerosOf(speedAt, within))
      zeros.push_back({positionAt(Moment(path, s)), s});
  }
  return zeros;
}

}  // namespace

CriticalCircle::CriticalCircle(const Pipe& pipe, const StepPath& path, double x, double s)
    : pipe_(pipe), path_(&path), x_(x), time_(s) {
  constexpr double kLongest = 0.25;  // of the step
  // How much of the speeds may be nonlinear: then psi turns nearly evenly around the window, and
  // the secant method of at() starts with a gain of about four.
  constexpr double kLinear = 0.25;
  constexpr double kShorter = 0.8;
  constexpr double kShortest = 1e-4;
  // mm: smaller windows help nothing. A cylinder that turns in a plane with its axis has a circle
  // of this kind at all times, which does not become another curve.
  constexpr double kNarrowest = 1e-3;
  byX_ = pipe.speedChanges(x, Moment(path, s));
  const Vector2d still = byTimeAt(pipe, path, x, s);
  drift_ = -still.dot(byX_) / byX_.squaredNorm();
  byTime_ = still + drift_ * byX_;
  slope_ = byTime_.norm() / byX_.norm();
  middle_ = std::atan2(-byTime_.x(), byTime_.y());
  duration_ = kLongest;
  while (!(nonlinearity() < kLinear) && duration_ > kShortest) duration_ *= kShorter;
  const double width = slope_ * duration_ * pipe.scale();
  if (duration_ <= kShortest || !(width > kNarrowest)) duration_ = 0;
}

CriticalCircle::Place CriticalCircle::placeOf(const Vector2d& on) const {
  const double after = on.y() * duration_;
  return {x_ + drift_ * after + on.x() * slope_ * duration_, time_ + after};
}

Vector2d CriticalCircle::speedsAt(const Vector2d& on) const {
  const Place place = placeOf(on);
  return pipe_.speeds(place.x, Moment(*path_, place.s));
}

double CriticalCircle::nonlinearity() const {
  constexpr int kPoints = 8;  // on each side
  double worst = 0;
  for (int i = 0; i < kPoints; ++i) {
    const double t = 2.0 * i / kPoints - 1;
    for (const Vector2d& on :
         {Vector2d(t, -1), Vector2d(1, t), Vector2d(-t, 1), Vector2d(-1, -t)}) {
      const Vector2d linear = duration_ * (on.x() * slope_ * byX_ + on.y() * byTime_);
      worst = std::max(worst, (speedsAt(on) - linear).norm() / linear.norm());
    }
  }
  return worst;
}

std::vector<CriticalCircle> CriticalCircle::find(const Pipe& pipe, const StepPath& path, Range x,
                                                 Range within, bool isClosed) {
  constexpr double kBeyond = 0.05;  // of the step: windows of circles there reach into it
  constexpr double kGap = 1.2;      // between windows, times their sizes
  constexpr double kShorter = 0.8;
  std::vector<CriticalCircle> found;
  for (const Zero& zero : zerosOn(pipe, path, within.grown(kBeyond))) {
    const double at = pipe.isCylinder() ? zero.x : angleNear(x.at(0.5), zero.x);
    CriticalCircle circle(pipe, path, at, zero.s);
    if (!circle.isValid()) continue;
    const Range times = circle.times();
    const double from = std::max(times.from, within.from), to = std::min(times.to, within.to);
    if (from >= to) continue;
    const Range first = circle.positions(from), last = circle.positions(to);
    const bool isInside =
        std::max(first.to, last.to) > x.from && std::min(first.from, last.from) < x.to;
    if (isClosed || isInside) found.push_back(circle);
  }
  const auto doOverlap = [&](const CriticalCircle& a, const CriticalCircle& b) {
    const double from = std::max(a.times().from, b.times().from),
                 to = std::min(a.times().to, b.times().to);
    if (from > to) return false;
    for (const double s : {from, to}) {
      const Range one = a.positions(s), other = b.positions(s);
      double apart = one.at(0.5) - other.at(0.5);
      if (!pipe.isCylinder()) apart = std::remainder(apart, 2 * M_PI);
      if (std::abs(apart) < kGap * (one.length() + other.length()) / 2) return true;
    }
    return false;
  };
  for (bool isChanged = true; isChanged;) {
    isChanged = false;
    for (std::size_t i = 0; i < found.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (!doOverlap(found[i], found[j])) continue;
        CriticalCircle& longer = found[i].duration_ > found[j].duration_ ? found[i] : found[j];
        longer.duration_ *= kShorter;
        isChanged = true;
      }
    }
  }
  return found;
}

Range CriticalCircle::positions(double s) const {
  const double middle = x_ + drift_ * (s - time_), half = slope_ * duration_;
  return {middle - half, middle + half};
}

double CriticalCircle::offsetOf(double x, double s) const {
  double off = x - x_ - drift_ * (s - time_);
  if (!pipe_.isCylinder()) off = std::remainder(off, 2 * M_PI);
  return off / (slope_ * duration_);
}

Range CriticalCircle::directions(int half) const {
  // Twice the angle by which the contact curves at the critical moment may turn in a window.
  constexpr double kWider = 0.5;
  return {onCircle(half).from - kWider, onCircle(half).to + kWider};
}

Range CriticalCircle::onCircle(int half) const {
  return {middleOf(half) - M_PI / 2, middleOf(half) + M_PI / 2};
}

Range CriticalCircle::reach(bool isAfter) {
  constexpr double kReach = 1.7;  // half of a diagonal of the window, and some margin
  return isAfter ? Range{0, kReach} : Range{-kReach, 0};
}

Vector2d CriticalCircle::lineOf(int half, double psi) const {
  const Vector2d n(std::cos(psi), std::sin(psi));
  const Vector2d line = Vector2d(n.dot(byTime_), -slope_ * n.dot(byX_)) / byTime_.norm();
  // In the middle of the half, it points to later times.
  const double middle = middleOf(half);
  const double later = -(std::cos(middle) * byX_.x() + std::sin(middle) * byX_.y());
  return later > 0 ? line : Vector2d(-line);
}

CriticalCircle::Place CriticalCircle::at(int half, double psi, double tau) const {
  constexpr int kRounds = 60;
  constexpr double kSame = 1e-15, kNearlySame = 1e-12;
  constexpr double kFar = 4;  // a step across the whole window
  const Vector2d n(std::cos(psi), std::sin(psi));
  const Vector2d line = lineOf(half, psi), across(-line.y(), line.x());
  const auto speed = [&](double off) { return n.dot(speedsAt(tau * line + off * across)); };
  double slope = duration_ * (across.x() * slope_ * n.dot(byX_) + across.y() * n.dot(byTime_));
  double off = 0, value = speed(0), last = HUGE_VAL;
  for (int round = 0; round < kRounds; ++round) {
    const double step = -value / slope;
    if (!std::isfinite(step) || std::abs(step) > kFar) return {NAN, NAN};
    off += step;
    // Rounding prevents smaller steps.
    if (std::abs(step) < kSame || (std::abs(step) < kNearlySame && std::abs(step) >= last / 2))
      return placeOf(tau * line + off * across);
    last = std::abs(step);
    const double next = speed(off);
    if (next != value) slope = (next - value) / step;
    value = next;
  }
  return {NAN, NAN};
}

Vector2d CriticalCircle::parametersOf(int half, double x, double psi, double s) const {
  const double direction = angleNear(middleOf(half), psi);
  const Vector2d on(offsetOf(x, s), (s - time_) / duration_);
  return {direction, lineOf(half, direction).dot(on)};
}

Vector2d CriticalCircle::directionAtMoment(double x) const {
  constexpr double kNear = 0.01;  // nearer, the speeds are rounded too much
  const double off = offsetOf(x, time_) * slope_ * duration_;
  const Moment moment(*path_, time_);
  Vector2d speeds = pipe_.speeds(x_ + off, moment) * (off > 0 ? 1 : -1);
  if (std::abs(off) < kNear * slope_ * duration_) {
    // The mean of the derivative from the circle to x, by the quadrature of Gauss with two points.
    const double place = 0.5 / std::sqrt(3.0);
    speeds = pipe_.speedChanges(x_ + (0.5 - place) * off, moment) +
             pipe_.speedChanges(x_ + (0.5 + place) * off, moment);
  }
  return Vector2d(speeds.y(), -speeds.x()).normalized();
}

}  // namespace swept::step
