// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/zero_curves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace swept::step {
namespace {

using Eigen::Vector2d;

// The zeros on the lines of a grid, joined by the cells of the grid (marching squares).
class ZeroGrid {
 public:
  ZeroGrid(const OfTwo& f, Range x, Range y) : f_(f), x_(x), y_(y) {
    for (int j = 0; j <= kRows; ++j) {
      for (int i = 0; i <= kColumns; ++i) isNegative_.push_back(f(node(i, j)) < 0);
    }
    for (int j = 0; j < kRows; ++j) {
      for (int i = 0; i < kColumns; ++i) joinIn(i, j);
    }
  }

  // Returns the points of each curve, in order. Closed curves end where they start.
  std::vector<std::vector<Vector2d>> curves() {
    std::vector<std::vector<Vector2d>> result;
    for (const bool isOpen : {true, false}) {
      for (std::size_t p = 0; p < points_.size(); ++p) {
        if (used_[p] || (isOpen && next_[p].size() > 1)) continue;
        std::vector<Vector2d>& curve = result.emplace_back();
        int at = static_cast<int>(p);
        while (at >= 0) {
          used_[at] = 1;
          curve.push_back(points_[at]);
          int after = -1;
          for (const int n : next_[at]) {
            if (!used_[n]) after = n;
          }
          at = after;
        }
        if (!isOpen) curve.push_back(curve.front());
      }
    }
    return result;
  }

 private:
  static constexpr int kColumns = 64, kRows = 128;

  Vector2d node(int i, int j) const {
    return {x_.at(static_cast<double>(i) / kColumns), y_.at(static_cast<double>(j) / kRows)};
  }
  bool isNegative(int i, int j) const { return isNegative_[j * (kColumns + 1) + i]; }

  // Returns the zero between two nodes.
  int pointBetween(const std::array<int, 2>& a, const std::array<int, 2>& b) {
    const auto [low, high] = std::minmax(a, b);
    const auto [it, isNew] = index_.emplace(std::pair(low, high), static_cast<int>(points_.size()));
    if (isNew) {
      const Vector2d from = node(low[0], low[1]), step = node(high[0], high[1]) - from;
      points_.push_back(from +
                        zeroBetween([&](double t) { return f_(from + t * step); }, 0, 1) * step);
      next_.emplace_back();
      used_.push_back(0);
    }
    return it->second;
  }

  void joinIn(int i, int j) {
    const std::array<std::array<int, 2>, 4> corners{
        {{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}}};
    std::vector<int> points;
    for (int k = 0; k < 4; ++k) {
      const auto &a = corners[k], &b = corners[(k + 1) % 4];
      if (isNegative(a[0], a[1]) != isNegative(b[0], b[1])) points.push_back(pointBetween(a, b));
    }
    if (points.size() == 4) {
      // The middle tells which corners are connected.
      const bool isMiddle = f_((node(i, j) + node(i + 1, j + 1)) / 2) < 0;
      if (isMiddle != isNegative(i, j))
        std::rotate(points.begin(), points.begin() + 1, points.end());
    }
    for (std::size_t k = 0; k + 1 < points.size(); k += 2) {
      next_[points[k]].push_back(points[k + 1]);
      next_[points[k + 1]].push_back(points[k]);
    }
  }

  const OfTwo& f_;
  const Range x_, y_;
  std::vector<char> isNegative_;
  std::map<std::pair<std::array<int, 2>, std::array<int, 2>>, int> index_;
  std::vector<Vector2d> points_;
  std::vector<std::vector<int>> next_;
  std::vector<char> used_;
};

// Removes points that are so near to the one before that they tell nothing about the direction. The
// ends stay.
void thin(std::vector<Vector2d>& points, double nearest) {
  std::vector<Vector2d> kept{points.front()};
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    if ((points[i] - kept.back()).norm() >= nearest) kept.push_back(points[i]);
  }
  while (kept.size() > 1 && (points.back() - kept.back()).norm() < nearest) kept.pop_back();
  kept.push_back(points.back());
  points = std::move(kept);
}

// Returns the smallest cosine of the angle between the direction and a chord.
double advanceOf(const std::vector<Vector2d>& points, const Vector2d& direction) {
  double least = 1;
  for (std::size_t i = 1; i < points.size(); ++i)
    least = std::min(least, (points[i] - points[i - 1]).normalized().dot(direction));
  return least;
}

}  // namespace

double zeroBetween(const OfOne& f, double a, double b) {
  // The ITP method: the secant method, never much slower than halving.
  constexpr int kHalvings = 60;
  constexpr double kEpsilon = 0x1p-52;
  const double precision = std::ldexp(std::abs(b - a), -kHalvings);
  const double truncation = 0.2 / std::abs(b - a);
  double fa = f(a), fb = f(b);
  if (fa == 0) return a;
  if (fb == 0) return b;
  for (int round = 0; std::abs(b - a) > precision; ++round) {
    const double middle = (a + b) / 2;
    const double slack =
        std::max(0.0, std::ldexp(precision, kHalvings + 1 - round) - std::abs(b - a)) / 2;
    const double secant = (fb * a - fa * b) / (fb - fa), toMiddle = middle - secant;
    double next = middle;
    if (std::isfinite(secant)) {
      // Towards the middle, so that the zero lies on the other side of the point: both ends move.
      const double least = std::max(precision, std::abs(secant) * kEpsilon);
      const double inward =
          std::min(std::abs(toMiddle), std::max(least, truncation * (b - a) * (b - a)));
      next = secant + std::copysign(inward, toMiddle);
      if (std::abs(next - middle) > slack) next = middle - std::copysign(slack, toMiddle);
    }
    if (next == a || next == b) next = middle;
    if (next == a || next == b) break;
    const double value = f(next);
    const bool isLikeA = (value < 0) == (fa < 0);
    (isLikeA ? a : b) = next;
    (isLikeA ? fa : fb) = value;
    if (value == 0) return next;
  }
  return (a + b) / 2;
}

std::vector<double> zerosOf(const OfOne& f, Range range) {
  std::vector<double> zeros;
  double a = range.from, fa = f(a);
  for (int i = 1; i <= kZeroSteps; ++i) {
    const double b = range.at(static_cast<double>(i) / kZeroSteps), fb = f(b);
    if ((fa < 0) != (fb < 0)) zeros.push_back(zeroBetween(f, a, b));
    a = b;
    fa = fb;
  }
  return zeros;
}

ZeroArc::ZeroArc(OfTwo f, Vector2d scale, Vector2d direction, std::vector<Vector2d> points)
    : f_(std::move(f)),
      scale_(std::move(scale)),
      direction_(std::move(direction)),
      points_(std::move(points)) {}

Range ZeroArc::range() const {
  return {points_.front().dot(direction_), points_.back().dot(direction_)};
}

Vector2d ZeroArc::at(double t) const {
  constexpr int kSecants = 30;
  const auto after = std::lower_bound(
      points_.begin() + 1, points_.end() - 1, t,
      [&](const Vector2d& point, double value) { return point.dot(direction_) < value; });
  const Vector2d &a = *(after - 1), &b = *after;
  const double from = a.dot(direction_), to = b.dot(direction_);
  const Vector2d start = a + (t - from) / (to - from) * (b - a),
                 across(-direction_.y(), direction_.x());
  const auto pointAt = [&](double off) -> Vector2d {
    return (start + off * across).cwiseQuotient(scale_);
  };
  // The secant method, across the direction.
  double off = 0, value = f_(pointAt(off));
  double nextOff = 1e-4 * (b - a).norm();
  for (int i = 0; i < kSecants && value != 0; ++i) {
    const double nextValue = f_(pointAt(nextOff));
    if (nextValue == value) break;
    const double newOff = nextOff - nextValue * (nextOff - off) / (nextValue - value);
    off = nextOff;
    value = nextValue;
    nextOff = newOff;
    constexpr double kSame = 1e-13;  // mm
    if (std::abs(nextOff - off) < kSame) break;
  }
  return pointAt(value == 0 ? off : nextOff);
}

std::vector<ZeroArc> zeroArcs(const OfTwo& f, Range x, Range y, const Vector2d& scale) {
  constexpr double kNearest = 0.002;  // of the sizes of the rectangle
  // Cosine of the largest angle between a curve and the direction along which it is a function.
  constexpr double kMinAdvance = 0.3;
  constexpr int kDirections = 8;
  const double nearest = kNearest * std::min(x.length() * scale.x(), y.length() * scale.y());
  std::vector<ZeroArc> arcs;
  std::vector<std::vector<Vector2d>> open;
  for (std::vector<Vector2d>& curve : ZeroGrid(f, x, y).curves()) {
    for (Vector2d& p : curve) p = p.cwiseProduct(scale);
    open.push_back(std::move(curve));
  }
  while (!open.empty()) {
    std::vector<Vector2d> points = std::move(open.back());
    open.pop_back();
    thin(points, nearest);
    if (points.size() < 2) continue;
    if (points.back().y() < points.front().y()) std::reverse(points.begin(), points.end());
    double best = -1;
    Vector2d direction;
    // The second parameter is preferred.
    for (int k = 0; k < 2 * kDirections && best < kMinAdvance; ++k) {
      const double angle = M_PI / 2 + k * M_PI / kDirections;
      const Vector2d candidate(k == 0 ? 0 : std::cos(angle), std::sin(angle));
      const double advance = advanceOf(points, candidate);
      if (advance <= best) continue;
      best = advance;
      direction = candidate;
    }
    if (best >= kMinAdvance) {
      arcs.emplace_back(f, scale, direction, std::move(points));
    } else if (points.size() > 2) {
      const auto middle = points.begin() + static_cast<std::ptrdiff_t>(points.size() / 2);
      open.emplace_back(points.begin(), middle + 1);
      open.emplace_back(middle, points.end());
    }
  }
  return arcs;
}

}  // namespace swept::step
