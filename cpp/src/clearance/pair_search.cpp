// SPDX-License-Identifier: LGPL-2.1-or-later
#include "clearance/pair_search.h"

#include <cmath>

namespace swept::clearance {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Gap of two boxes at one pose: lower bound of the distance, and the direction in which it is a
// slab.
class BoxGap {
 public:
  BoxGap(const Matrix3d& R, const Vector3d& t) : R_(R), t_(t), absolute_(R.cwiseAbs()) {}

  // Box against box in the neighbour's axes. The moving box is replaced by its box in these axes.
  double inWorld(const BoxNode& moving, const BoxNode& still) {
    offset_ = still.centre - (R_ * moving.centre + t_);
    world_ = (offset_.cwiseAbs() - absolute_ * moving.half - still.half).cwiseMax(0.0);
    return world_.norm();
  }
  // The same in the body's axes; after inWorld() of the same pair.
  double inBody(const BoxNode& moving, const BoxNode& still) {
    local_ = R_.transpose() * offset_;
    gap_ = (local_.cwiseAbs() - moving.half - absolute_.transpose() * still.half).cwiseMax(0.0);
    return gap_.norm();
  }
  Vector3d worldDirection(double length) const { return signedLike(world_, offset_) / length; }
  Vector3d bodyDirection(double length) const { return R_ * (signedLike(gap_, local_) / length); }

 private:
  static Vector3d signedLike(const Vector3d& size, const Vector3d& sign) {
    return {std::copysign(size[0], sign[0]), std::copysign(size[1], sign[1]),
            std::copysign(size[2], sign[2])};
  }
  const Matrix3d& R_;
  const Vector3d& t_;
  Matrix3d absolute_;
  Vector3d offset_, world_, local_, gap_;
};

struct Item {
  std::int32_t body;
  std::int32_t neighbour;
  double gap;
};

// One stack for each thread and call depth 1: searches never nest.
std::vector<Item>& scratch() {
  static thread_local std::vector<Item> stack;
  stack.clear();
  return stack;
}

bool descendBody(const BoxNode& a, const BoxNode& b) {
  if (a.leaf >= 0) return false;
  if (b.leaf >= 0) return true;
  return a.half.squaredNorm() >= b.half.squaredNorm();
}

Corners posed(const Matrix3d& R, const Vector3d& t, const Corners& c) {
  return {Vector3d(R * c[0] + t), Vector3d(R * c[1] + t), Vector3d(R * c[2] + t)};
}

// Largest advance along n of a triangle: displacements are affine, so a corner has the largest.
double advanceOf(const MotionBound& motion, const Vector3d& n, const Corners& c) {
  double a = 0;
  for (const Vector3d& x : c) a = std::max(a, motion.advance(n, x, Vector3d::Zero()));
  return a;
}

// Gap of two triangles along a direction that stands on one of them or joins their middles; the
// direction is turned from a to b. A lower bound of the distance that costs a tenth of it.
struct Slab {
  double gap = -1;
  Vector3d direction = Vector3d::Zero();

  Slab(const Corners& a, const Corners& b) {
    tryAlong(a, b, (b[0] + b[1] + b[2]) - (a[0] + a[1] + a[2]));
    tryAlong(a, b, (a[1] - a[0]).cross(a[2] - a[0]));
    tryAlong(a, b, (b[1] - b[0]).cross(b[2] - b[0]));
  }

 private:
  void tryAlong(const Corners& a, const Corners& b, const Vector3d& n) {
    const double length = n.norm();
    if (!(length > 1e-150)) return;
    const double a0 = n.dot(a[0]), a1 = n.dot(a[1]), a2 = n.dot(a[2]);
    const double b0 = n.dot(b[0]), b1 = n.dot(b[1]), b2 = n.dot(b[2]);
    const double ahead = std::min({b0, b1, b2}) - std::max({a0, a1, a2});
    const double behind = std::min({a0, a1, a2}) - std::max({b0, b1, b2});
    const double most = std::max(ahead, behind) / length;
    if (most <= gap) return;
    gap = most;
    direction = (ahead >= behind ? n : Vector3d(-n)) / length;
  }
};

}  // namespace

NearestPoints PairSearch::leafDistance(const Matrix3d& R, const Vector3d& t, LeafPair pair) const {
  return nearestPoints(posed(R, t, body_.corners(pair.body)), neighbour_.corners(pair.neighbour));
}

PairDistance PairSearch::distanceAt(const Matrix3d& R, const Vector3d& t, double below,
                                    LeafPair hint) const {
  PairDistance best;
  best.distance = below;
  const auto tryPair = [&](LeafPair pair) {
    const Corners a = posed(R, t, body_.corners(pair.body));
    const Corners& b = neighbour_.corners(pair.neighbour);
    if (Slab(a, b).gap >= best.distance) return;
    const NearestPoints p = nearestPoints(a, b);
    const double d = std::sqrt(p.squared);
    if (d < best.distance) best = {d, pair, p.a, p.b};
  };
  if (hint.body >= 0) tryPair(hint);
  BoxGap gap(R, t);
  const auto gapOf = [&](std::int32_t i, std::int32_t j) {
    const BoxNode& a = body_.nodes()[i];
    const BoxNode& b = neighbour_.nodes()[j];
    const double first = gap.inWorld(a, b);
    return first >= best.distance ? first : std::max(first, gap.inBody(a, b));
  };
  std::vector<Item>& stack = scratch();
  stack.push_back({0, 0, gapOf(0, 0)});
  while (!stack.empty() && best.distance > 0) {
    const Item item = stack.back();
    stack.pop_back();
    if (item.gap >= best.distance) continue;
    const BoxNode& a = body_.nodes()[item.body];
    const BoxNode& b = neighbour_.nodes()[item.neighbour];
    if (a.leaf >= 0 && b.leaf >= 0) {
      tryPair({a.leaf, b.leaf});
      continue;
    }
    Item first;
    Item second;
    if (descendBody(a, b)) {
      first = {item.body + 1, item.neighbour, gapOf(item.body + 1, item.neighbour)};
      second = {a.right, item.neighbour, gapOf(a.right, item.neighbour)};
    } else {
      first = {item.body, item.neighbour + 1, gapOf(item.body, item.neighbour + 1)};
      second = {item.body, b.right, gapOf(item.body, b.right)};
    }
    if (second.gap < first.gap) std::swap(first, second);
    if (second.gap < best.distance) stack.push_back(second);
    if (first.gap < best.distance) stack.push_back(first);
  }
  return best;
}

Certificate PairSearch::certify(const MotionBound& motion, double apart, std::int64_t effort,
                                LeafPair hint) const {
  Certificate result;
  const auto pairHolds = [&](LeafPair pair) {
    const Corners a = posed(motion.R, motion.t, body_.corners(pair.body));
    const Corners& b = neighbour_.corners(pair.neighbour);
    const Slab slab(a, b);
    if (slab.gap - motion.reach >= apart) return true;
    if (slab.gap >= apart &&
        slab.gap - advanceOf(motion, slab.direction, body_.corners(pair.body)) >= apart)
      return true;
    const NearestPoints p = nearestPoints(a, b);
    const double d = std::sqrt(p.squared);
    double least = d - motion.reach;
    if (d > 0 && least < apart)
      least = std::max(least, d - advanceOf(motion, (p.b - p.a) / d, body_.corners(pair.body)));
    if (least >= apart) return true;
    result.obstacle = pair;
    result.estimate = least;
    return false;
  };
  if (hint.body >= 0 && !pairHolds(hint)) return result;
  BoxGap gap(motion.R, motion.t);
  // -1: proven apart; otherwise the gap, for ordering.
  const auto openGap = [&](std::int32_t i, std::int32_t j) {
    const BoxNode& a = body_.nodes()[i];
    const BoxNode& b = neighbour_.nodes()[j];
    const double first = gap.inWorld(a, b);
    if (first - motion.reach >= apart) return -1.0;
    const double second = gap.inBody(a, b);
    if (second - motion.reach >= apart) return -1.0;
    if (first > apart &&
        first - motion.advance(gap.worldDirection(first), a.centre, a.half) >= apart)
      return -1.0;
    if (second > apart &&
        second - motion.advance(gap.bodyDirection(second), a.centre, a.half) >= apart)
      return -1.0;
    return std::max(first, second);
  };
  std::vector<Item>& stack = scratch();
  const auto push = [&](std::int32_t i, std::int32_t j) {
    const double g = openGap(i, j);
    if (g >= 0) stack.push_back({i, j, g});
  };
  push(0, 0);
  while (!stack.empty()) {
    if (--effort < 0) return result;
    const Item item = stack.back();
    stack.pop_back();
    const BoxNode& a = body_.nodes()[item.body];
    const BoxNode& b = neighbour_.nodes()[item.neighbour];
    if (a.leaf >= 0 && b.leaf >= 0) {
      if (!pairHolds({a.leaf, b.leaf})) return result;
      continue;
    }
    const std::size_t before = stack.size();
    if (descendBody(a, b)) {
      push(item.body + 1, item.neighbour);
      push(a.right, item.neighbour);
    } else {
      push(item.body, item.neighbour + 1);
      push(item.body, b.right);
    }
    // The nearer one on top: an obstacle, if there is one, is met soon.
    if (stack.size() == before + 2 && stack[before].gap < stack[before + 1].gap)
      std::swap(stack[before], stack[before + 1]);
  }
  result.holds = true;
  return result;
}

bool PairSearch::containedAt(const Matrix3d& R, const Vector3d& t) const {
  for (const Vector3d& x : body_.pieces())
    if (neighbour_.inside(R * x + t)) return true;
  for (const Vector3d& x : neighbour_.pieces())
    if (body_.inside(R.transpose() * (x - t))) return true;
  return false;
}

std::vector<LeafPair> PairSearch::meetingPairs(const Matrix3d& R, const Vector3d& t,
                                               std::size_t limit) const {
  std::vector<LeafPair> found;
  BoxGap gap(R, t);
  std::vector<Item>& stack = scratch();
  stack.push_back({0, 0, 0});
  while (!stack.empty() && found.size() < limit) {
    const Item item = stack.back();
    stack.pop_back();
    const BoxNode& a = body_.nodes()[item.body];
    const BoxNode& b = neighbour_.nodes()[item.neighbour];
    if (gap.inWorld(a, b) > 0 || gap.inBody(a, b) > 0) continue;
    if (a.leaf >= 0 && b.leaf >= 0) {
      if (!(leafDistance(R, t, {a.leaf, b.leaf}).squared > 0)) found.push_back({a.leaf, b.leaf});
    } else if (descendBody(a, b)) {
      stack.push_back({item.body + 1, item.neighbour, 0});
      stack.push_back({a.right, item.neighbour, 0});
    } else {
      stack.push_back({item.body, item.neighbour + 1, 0});
      stack.push_back({item.body, b.right, 0});
    }
  }
  return found;
}

}  // namespace swept::clearance
