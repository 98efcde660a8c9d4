// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/recognise/trace_points.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <set>

namespace swept::step {
namespace {

using Eigen::Vector2d;

constexpr double kReach = 1.0 / 80;     // fraction of the box: radius in which a step uses points
constexpr double kMaxReach = 1.0 / 6;   // the same, where points are sparse
constexpr double kMinSameCosine = 0.7;  // cosine: normals at a larger angle are ignored
constexpr int kMaxSteps = 1500;
/// Fraction of the box's size; points nearer to each other than this count as one.
constexpr double kMinSpacing = 1.0 / 800;
constexpr int kCells = 80;

class Tracer {
 public:
  Tracer(const std::vector<Vector2d>& points, const std::vector<Vector2d>& normals)
      : points_(points), normals_(normals) {
    low_ = Vector2d::Constant(1e300);
    Vector2d high = -low_;
    for (const Vector2d& p : points) {
      low_ = low_.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    size_ = (high - low_).norm();
    cell_ = std::max(1e-12, (high - low_).maxCoeff() / kCells);
    cells_.resize(static_cast<std::size_t>(kCells + 1) * (kCells + 1));
    for (std::size_t i = 0; i < points.size(); ++i)
      cells_[cellOf(points[i])].push_back(static_cast<std::int32_t>(i));
  }

  std::optional<Trace> trace() {
    if (points_.size() < 12 || !(size_ > 0)) return std::nullopt;
    State start{points_.front(), normals_.front(), 0};
    if (!settle(start)) return std::nullopt;
    std::deque<State> path{start};
    const bool closed = follow(1, path);
    if (!closed) follow(-1, path);
    if (path.size() < 4) return std::nullopt;
    Trace result;
    result.closed = closed;
    if (closed) {
      path.push_back(path.front());
    } else {
      path.push_back(beyond(path.back(), 1));
      path.push_front(beyond(path.front(), -1));
    }
    for (const State& state : path) {
      if (!result.points.empty()) {
        const double step = (state.at - result.points.back()).norm();
        result.along.push_back(result.along.back() + step);
        result.turn += std::acos(std::clamp(state.normal.dot(result.normals.back()), -1.0, 1.0));
      } else {
        result.along.push_back(0);
      }
      result.points.push_back(state.at);
      result.normals.push_back(state.normal);
    }
    result.reach = 0.5 * kMaxReach * size_;
    return result;
  }

 private:
  struct State {
    Vector2d at, normal;
    double bend = 0;
  };

  std::size_t cellOf(const Vector2d& p) const {
    const int x = std::clamp(static_cast<int>((p.x() - low_.x()) / cell_), 0, kCells);
    const int y = std::clamp(static_cast<int>((p.y() - low_.y()) / cell_), 0, kCells);
    return static_cast<std::size_t>(y) * (kCells + 1) + x;
  }

  template <class Use>
  void around(const Vector2d& centre, double radius, const Use& use) const {
    const Vector2d half = Vector2d::Constant(radius);
    const std::size_t from = cellOf(centre - half), to = cellOf(centre + half);
    for (std::size_t y = from / (kCells + 1); y <= to / (kCells + 1); ++y) {
      for (std::size_t x = from % (kCells + 1); x <= to % (kCells + 1); ++x) {
        for (const std::int32_t i : cells_[y * (kCells + 1) + x]) {
          if ((points_[i] - centre).squaredNorm() <= radius * radius) use(i);
        }
      }
    }
  }

  // Moves the state onto a parabola through the points around it. The radius grows until six points
  // extend over at least half of it.
  bool settle(State& state) {
    for (radius_ = kReach * size_; radius_ <= kMaxReach * size_; radius_ *= 1.6) {
      const Vector2d tangent(-state.normal.y(), state.normal.x());
      Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
      Eigen::Vector3d right = Eigen::Vector3d::Zero();
      double smallest = 0, largest = 0;
      int count = 0;
      around(state.at, radius_, [&](std::int32_t i) {
        if (normals_[i].dot(state.normal) < kMinSameCosine) return;
        const Vector2d d = points_[i] - state.at;
        const double s = d.dot(tangent) / radius_;
        const double weight = 1.01 - d.squaredNorm() / (radius_ * radius_);
        const Eigen::Vector3d row(1, s, s * s);
        moments += weight * row * row.transpose();
        right += weight * row * d.dot(state.normal);
        smallest = std::min(smallest, s);
        largest = std::max(largest, s);
        ++count;
      });
      if (count < 6 || largest - smallest < 0.5) continue;
      moments(2, 2) += 1e-3 * moments(0, 0);
      moments.diagonal().array() += 1e-12 * moments(0, 0);
      const Eigen::Vector3d fit = moments.ldlt().solve(right);
      if (!fit.allFinite() || std::abs(fit[0]) > 0.7 * radius_) return false;
      const double slope = fit[1] / radius_;
      if (std::abs(slope) > 1) return false;
      state.at += fit[0] * state.normal;
      state.normal = (state.normal - slope * tangent).normalized();
      state.bend = 2 * fit[2] / (radius_ * radius_);
      return true;
    }
    return false;
  }

  // Appends states to the back of the path (sense = 1) or to its front (-1). Returns true if the
  // path comes back to its other end.
  bool follow(double sense, std::deque<State>& path) {
    const State first = sense > 0 ? path.front() : path.back();
    State here = sense > 0 ? path.back() : path.front();
    if (!settle(here)) return false;  // this call also sets radius_
    double walked = 0;
    for (int i = 0; i < kMaxSteps; ++i) {
      State state = sense > 0 ? path.back() : path.front();
      const Vector2d tangent = sense * Vector2d(-state.normal.y(), state.normal.x());
      if (!goesOn(state, tangent)) return false;
      const double step = 0.5 * radius_;
      const double turned = std::clamp(state.bend * step, -0.4, 0.4);
      state.at += step * (tangent + 0.5 * turned * state.normal);
      state.normal = (state.normal - turned * tangent).normalized();
      if (!settle(state)) return false;
      const State& before = sense > 0 ? path.back() : path.front();
      const double moved = (state.at - before.at).dot(tangent);
      if (!(moved > 0.1 * step)) return false;
      walked += moved;
      if (walked > 6 * radius_ && (state.at - first.at).norm() < 0.8 * radius_ &&
          state.normal.dot(first.normal) > kMinSameCosine)
        return true;
      sense > 0 ? path.push_back(state) : path.push_front(state);
    }
    return false;
  }

  // Returns a state beyond the end, since the path stops slightly before the last points.
  State beyond(const State& end, double sense) {
    State next = end;
    settle(next);
    next.at = end.at + sense * 0.5 * radius_ * Vector2d(-end.normal.y(), end.normal.x());
    next.normal = end.normal;
    return next;
  }

  // Whether there are points ahead. The radius grows if they are sparse.
  bool goesOn(const State& state, const Vector2d& tangent) {
    for (; radius_ <= kMaxReach * size_; radius_ *= 1.6) {
      double largest = 0;
      around(state.at, radius_, [&](std::int32_t i) {
        if (normals_[i].dot(state.normal) >= kMinSameCosine)
          largest = std::max(largest, (points_[i] - state.at).dot(tangent));
      });
      if (largest > 0.3 * radius_) return true;
    }
    return false;
  }

  const std::vector<Vector2d>& points_;
  const std::vector<Vector2d>& normals_;
  Vector2d low_ = Vector2d::Zero();
  double size_ = 0, cell_ = 1, radius_ = 0;
  std::vector<std::vector<std::int32_t>> cells_;
};

}  // namespace

double Trace::parameterOf(const Vector2d& p, const Vector2d& normal) const {
  double smallest = reach * reach, position = -1;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    if (normals[i].dot(normal) < 0.5 * kMinSameCosine) continue;
    const Vector2d ab = points[i + 1] - points[i];
    const double length2 = std::max(1e-300, ab.squaredNorm());
    const double w = std::clamp((p - points[i]).dot(ab) / length2, 0.0, 1.0);
    const double distance2 = (p - points[i] - w * ab).squaredNorm();
    if (distance2 >= smallest) continue;
    smallest = distance2;
    position = along[i] + w * std::sqrt(length2);
  }
  return position;
}

std::optional<Trace> tracePoints(const std::vector<Vector2d>& points,
                                 const std::vector<Vector2d>& normals) {
  // Points that coincide, for example along a line of an extrusion, count once.
  Vector2d low = Vector2d::Constant(1e300), high = -low;
  for (const Vector2d& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double fine = kMinSpacing * (high - low).norm();
  if (!(fine > 0)) return std::nullopt;
  std::set<std::array<int, 3>> seen;
  std::vector<Vector2d> left, leftNormals;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector2d position = (points[i] - low) / fine;
    const int side = (normals[i].x() > 0 ? 1 : 0) + (normals[i].y() > 0 ? 2 : 0);
    if (!seen.insert({static_cast<int>(position.x()), static_cast<int>(position.y()), side}).second)
      continue;
    left.push_back(points[i]);
    leftNormals.push_back(normals[i]);
  }
  return Tracer(left, leftNormals).trace();
}

}  // namespace swept::step
