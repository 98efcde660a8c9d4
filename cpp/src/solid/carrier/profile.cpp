// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/carrier/profile.h"

#include <algorithm>
#include <cmath>

namespace swept::step {
namespace {

using Eigen::Vector2d;

constexpr int kSamplesPerSpan = 6;
constexpr int kCells = 64;  // grid cells along the longer side of the box

Vector2d rightOf(const Vector2d& v) { return {v.y(), -v.x()}; }

}  // namespace

Profile::Profile(std::vector<Node> nodes, bool closed, double beyond)
    : nodes_(std::move(nodes)), closed_(closed), beyond_(closed ? 0 : beyond) {
  first_ = nodes_.front().knot;
  last_ = nodes_.back().knot;
  if (beyond_ > 0) {
    // The end pieces are straight and have the same derivative everywhere.
    for (const double direction : {-1.0, 1.0}) {
      Node end = direction < 0 ? nodes_.front() : nodes_.back();
      end.knot += direction * beyond_ / end.slope.norm();
      end.at += direction * beyond_ * end.slope.normalized();
      nodes_.insert(direction < 0 ? nodes_.begin() : nodes_.end(), end);
    }
  }
  sample();
}

std::size_t Profile::spanOf(double t) const {
  std::size_t low = 0, high = nodes_.size() - 1;
  while (high - low > 1) {
    const std::size_t middle = (low + high) / 2;
    (nodes_[middle].knot <= t ? low : high) = middle;
  }
  return low;
}

Vector2d Profile::at(double t) const {
  const std::size_t i = spanOf(t);
  const Node &a = nodes_[i], &b = nodes_[i + 1];
  const double h = b.knot - a.knot, w = (t - a.knot) / h, m = 1 - w;
  return m * m * (1 + 2 * w) * a.at + w * w * (1 + 2 * m) * b.at +
         h * w * m * (m * a.slope - w * b.slope);
}

void Profile::derivatives(double t, Vector2d& first, Vector2d& second) const {
  const std::size_t i = spanOf(t);
  const Node &a = nodes_[i], &b = nodes_[i + 1];
  const double h = b.knot - a.knot, w = (t - a.knot) / h, m = 1 - w;
  const Vector2d chord = (b.at - a.at) / h;
  first = 6 * w * m * chord + m * (1 - 3 * w) * a.slope + w * (3 * w - 2) * b.slope;
  second = ((6 - 12 * w) * chord + (6 * w - 4) * a.slope + (6 * w - 2) * b.slope) / h;
}

void Profile::sample() {
  for (std::size_t i = 0; i + 1 < nodes_.size(); ++i) {
    for (int k = 0; k < kSamplesPerSpan; ++k) {
      sampleAt_.push_back(nodes_[i].knot +
                          (nodes_[i + 1].knot - nodes_[i].knot) * k / kSamplesPerSpan);
    }
  }
  sampleAt_.push_back(nodes_.back().knot);
  low_ = Vector2d::Constant(1e300);
  Vector2d high = -low_;
  for (const double t : sampleAt_) {
    samples_.push_back(at(t));
    low_ = low_.cwiseMin(samples_.back());
    high = high.cwiseMax(samples_.back());
  }
  cell_ = std::max(1e-9, (high - low_).maxCoeff() / kCells);
  low_.array() -= 2 * cell_;
  high.array() += 2 * cell_;
  for (int k = 0; k < 2; ++k) count_[k] = static_cast<int>((high[k] - low_[k]) / cell_) + 1;
  std::vector<std::vector<std::int32_t>> cells(static_cast<std::size_t>(count_.prod()));
  for (std::size_t i = 0; i + 1 < samples_.size(); ++i)
    addToCells(static_cast<std::int32_t>(i), cells);
  for (const auto& cell : cells) {
    cellStart_.push_back(static_cast<std::int32_t>(cellSegments_.size()));
    cellSegments_.insert(cellSegments_.end(), cell.begin(), cell.end());
  }
  cellStart_.push_back(static_cast<std::int32_t>(cellSegments_.size()));
}

// Adds the segment to each grid cell within one cell of it. So a segment that a cell does not list
// is farther away than the edge length of a cell.
void Profile::addToCells(std::int32_t segment,
                         std::vector<std::vector<std::int32_t>>& cells) const {
  const Vector2d &a = samples_[segment], &b = samples_[segment + 1];
  const Vector2d from = (a.cwiseMin(b) - low_) / cell_, to = (a.cwiseMax(b) - low_) / cell_;
  for (int y = std::max(0, static_cast<int>(from.y()) - 1);
       y <= std::min(count_.y() - 1, static_cast<int>(to.y()) + 1); ++y) {
    for (int x = std::max(0, static_cast<int>(from.x()) - 1);
         x <= std::min(count_.x() - 1, static_cast<int>(to.x()) + 1); ++x)
      cells[static_cast<std::size_t>(y) * count_.x() + x].push_back(segment);
  }
}

// Returns the parameter of the segment point nearest to q, if its squared distance is below
// `smallest`, and updates `smallest`. Otherwise returns -1e300.
double Profile::bestOn(std::int32_t segment, const Vector2d& q, double& smallest) const {
  const Vector2d &a = samples_[segment], ab = samples_[segment + 1] - a;
  const double w = std::clamp((q - a).dot(ab) / std::max(1e-300, ab.squaredNorm()), 0.0, 1.0);
  const double offset = (q - a - w * ab).squaredNorm();
  if (!(offset < smallest)) return -1e300;
  smallest = offset;
  return sampleAt_[segment] + w * (sampleAt_[segment + 1] - sampleAt_[segment]);
}

Profile::Foot Profile::foot(const Vector2d& q) const {
  double smallest = 1e300, t = nodes_.front().knot;
  const auto visit = [&](std::int32_t segment) {
    const double found = bestOn(segment, q, smallest);
    if (found > -1e299) t = found;
  };
  const Vector2d position = (q - low_) / cell_;
  if (position.minCoeff() >= 0 && position.x() < count_.x() && position.y() < count_.y()) {
    const std::size_t cell = static_cast<std::size_t>(position.y()) * count_.x() +
                             static_cast<std::size_t>(position.x());
    for (std::int32_t i = cellStart_[cell]; i < cellStart_[cell + 1]; ++i) visit(cellSegments_[i]);
  }
  if (!(smallest < cell_ * cell_)) {
    for (std::size_t i = 0; i + 1 < samples_.size(); ++i) visit(static_cast<std::int32_t>(i));
  }
  const double begin = nodes_.front().knot, end = nodes_.back().knot;
  Vector2d first, second;
  for (int round = 0; round < 4; ++round) {
    derivatives(t, first, second);
    const Vector2d offset = at(t) - q;
    const double slope = first.squaredNorm() + offset.dot(second);
    if (!(slope > 0.1 * first.squaredNorm())) break;
    double next = t - offset.dot(first) / slope;
    if (closed_ && next < begin) next += end - begin;
    if (closed_ && next > end) next -= end - begin;
    next = std::clamp(next, begin, end);
    const double step = std::abs(next - t);
    t = next;
    if (step < 1e-10 * (end - begin)) break;
  }
  derivatives(t, first, second);
  return {t, at(t), first.normalized()};
}

double Profile::distance(const Vector2d& q) const {
  const Foot near = foot(q);
  const Vector2d offset = q - near.at;
  const double right = offset.dot(rightOf(near.tangent)), past = std::abs(offset.dot(near.tangent));
  // If so, the point lies beyond a straight end piece.
  if (past > 1e-6 * length()) return right < 0 ? -offset.norm() : offset.norm();
  return right;
}

Vector2d Profile::normal(const Vector2d& q) const { return rightOf(foot(q).tangent); }

bool Profile::covers(const Vector2d& q) const {
  if (closed_) return true;
  const double t = foot(q).t;
  return t > first_ && t < last_;
}

Profile Profile::offset(double right) const {
  Profile moved = *this;
  moved.samples_.clear();
  moved.sampleAt_.clear();
  moved.cellStart_.clear();
  moved.cellSegments_.clear();
  for (Node& node : moved.nodes_) {
    Vector2d first, second;
    derivatives(node.knot, first, second);
    node.at += right * rightOf(first.normalized());
    const double bend =
        (first.x() * second.y() - first.y() * second.x()) / std::pow(first.norm(), 3);
    node.slope *= 1 + right * bend;
  }
  moved.sample();
  return moved;
}

Profile Profile::opened(double from, double to) const {
  const double period = length();
  std::vector<Node> kept;
  if (to <= from) to += period;
  const auto nodeAt = [&](double t) {
    const double inside = t >= nodes_.back().knot ? t - period : t;
    Vector2d first, second;
    derivatives(inside, first, second);
    return Node{at(inside), first, t};
  };
  kept.push_back(nodeAt(from));
  const double margin = 1e-3 * period;
  for (const double shift : {0.0, period}) {
    for (std::size_t i = 0; i + 1 < nodes_.size(); ++i) {
      const double t = nodes_[i].knot + shift;
      if (t > from + margin && t < to - margin) kept.push_back(nodeAt(t));
    }
  }
  kept.push_back(nodeAt(to));
  return {std::move(kept), false, 0};
}

}  // namespace swept::step
