// SPDX-License-Identifier: LGPL-2.1-or-later
#include "clearance/pair_search.h"

#include <array>
#include <cmath>
#include <stdexcept>

namespace swept::clearance {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Gap of two boxes at one pose, a lower bound of their distance. Along the direction of the gap,
// the boxes are at least this far apart.
class BoxGap {
 public:
  BoxGap(const Matrix3d& R, const Vector3d& t) : R_(R), t_(t), absolute_(R.cwiseAbs()) {}

  // Returns the gap along the axes of the neighbour. The moving box is replaced by its bounding box
  // with these axes.
  double inWorld(const Box& moving, const Box& still) {
    offset_ = still.centre - (R_ * moving.centre + t_);
    world_ = (offset_.cwiseAbs() - absolute_ * moving.half - still.half).cwiseMax(0.0);
    return world_.norm();
  }
  // Returns the gap along the axes of the body. Requires that inWorld() was called for the same
  // pair before, which sets offset_.
  double inBody(const Box& moving, const Box& still) {
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

// Gap of two nodes at one pose. Plates (plates.h) are compared only if the boxes are not far enough
// apart.
class NodeGap {
 public:
  NodeGap(const Part& body, const Part& neighbour, const Matrix3d& R, const Vector3d& t)
      : body_(body), neighbour_(neighbour), boxes_(R, t), plates_(R, t) {}

  /// Returns a lower bound of the distance in mm. Stops refining the bound as soon as it reaches
  /// `enough`.
  double between(BoxTree::Node i, const Box& a, BoxTree::Node j, const Box& b, double enough) {
    double gap = boxes_.inWorld(a, b);
    if (gap < enough) gap = std::max(gap, boxes_.inBody(a, b));
    if (gap < enough) gap = std::max(gap, betweenPlates(i, j));
    return gap;
  }
  /// Returns 0 if one of the nodes has no plate.
  double betweenPlates(BoxTree::Node i, BoxTree::Node j) {
    const Plate* a = body_.plate(i);
    const Plate* b = neighbour_.plate(j);
    return a && b ? plates_.between(*a, *b) : 0.0;
  }
  BoxGap& boxes() { return boxes_; }
  const PlateGap& plates() const { return plates_; }

 private:
  const Part& body_;
  const Part& neighbour_;
  BoxGap boxes_;
  PlateGap plates_;
};

struct NodePair {
  BoxTree::Node body;
  BoxTree::Node neighbour;
  double gap = 0;

  bool isPair() const { return body.isItem() && neighbour.isItem(); }
  LeafPair pair() const {
    return {static_cast<std::int32_t>(body.index), static_cast<std::int32_t>(neighbour.index)};
  }
};

// Stack of the pairs that have not been examined. The search goes depth first and replaces one node
// by its four children at a time. So the stack holds at most 1 + 3 * (levels of both trees) pairs.
class Stack {
 public:
  Stack(const Part& body, const Part& neighbour) {
    const int levels = body.tree().root().level + neighbour.tree().root().level;
    if (1 + (BoxTree::kWidth - 1) * levels > kCapacity)
      throw std::logic_error("a tree of boxes is deeper than 32-bit numbers of items allow");
  }
  bool empty() const { return size_ == 0; }
  int size() const { return size_; }
  NodePair& operator[](int i) { return items_[i]; }
  void push(const NodePair& item) { items_[size_++] = item; }
  NodePair pop() { return items_[--size_]; }

 private:
  static constexpr int kCapacity = 128;
  std::array<NodePair, kCapacity> items_;
  int size_ = 0;
};

// Replaces the node with the larger box by its children and calls visit(body node, its box,
// neighbour node, its box) for each.
template <class Visit>
void openLarger(const Part& body, const Part& neighbour, const NodePair& item, const Visit& visit) {
  const Box a = body.box(item.body), b = neighbour.box(item.neighbour);
  const bool opensBody = !item.body.isItem() &&
                         (item.neighbour.isItem() || a.half.squaredNorm() >= b.half.squaredNorm());
  const BoxTree::Node open = opensBody ? item.body : item.neighbour;
  const std::uint32_t children = (opensBody ? body : neighbour).tree().children(open);
  for (std::uint32_t c = 0; c < children; ++c) {
    const BoxTree::Node child = BoxTree::child(open, c);
    if (opensBody) {
      visit(child, body.box(child), item.neighbour, b);
    } else {
      visit(item.body, a, child, neighbour.box(child));
    }
  }
}

// Sorts the entries from `first` on, so that the nearest pair is taken from the stack first.
void sortFrom(int first, Stack& stack) {
  for (int i = first + 1; i < stack.size(); ++i) {
    for (int at = i; at > first && stack[at - 1].gap < stack[at].gap; --at)
      std::swap(stack[at - 1], stack[at]);
  }
}

Triangle3d posed(const Matrix3d& R, const Vector3d& t, const Triangle3d& c) {
  return {Vector3d(R * c[0] + t), Vector3d(R * c[1] + t), Vector3d(R * c[2] + t)};
}

// Returns the largest advance of a triangle along n. Displacements are affine, so a corner has the
// largest advance.
double advanceOf(const MotionBound& motion, const Vector3d& n, const Triangle3d& c) {
  double a = 0;
  for (const Vector3d& x : c) a = std::max(a, motion.advance(n, x, Vector3d::Zero()));
  return a;
}

// Gap of two triangles along a direction from a to b: the normal of either triangle, or the line
// between their centroids. The gap is a lower bound of the distance. Computing it takes a tenth of
// the time of the exact distance.
struct Slab {
  double gap = -1;
  Vector3d direction = Vector3d::Zero();

  Slab(const Triangle3d& a, const Triangle3d& b) {
    tryAlong(a, b, (b[0] + b[1] + b[2]) - (a[0] + a[1] + a[2]));
    tryAlong(a, b, (a[1] - a[0]).cross(a[2] - a[0]));
    tryAlong(a, b, (b[1] - b[0]).cross(b[2] - b[0]));
  }

 private:
  void tryAlong(const Triangle3d& a, const Triangle3d& b, const Vector3d& n) {
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
    const Triangle3d a = posed(R, t, body_.corners(pair.body));
    const Triangle3d& b = neighbour_.corners(pair.neighbour);
    if (Slab(a, b).gap >= best.distance) return;
    const NearestPoints p = nearestPoints(a, b);
    const double d = std::sqrt(p.squared);
    if (d < best.distance) best = {d, pair, p.a, p.b};
  };
  if (hint.body >= 0) tryPair(hint);
  NodeGap gap(body_, neighbour_, R, t);
  Stack stack(body_, neighbour_);
  const auto push = [&](BoxTree::Node i, const Box& a, BoxTree::Node j, const Box& b) {
    const double g = gap.between(i, a, j, b, best.distance);
    if (g < best.distance) stack.push({i, j, g});
  };
  const BoxTree::Node bodyRoot = body_.tree().root(), root = neighbour_.tree().root();
  push(bodyRoot, body_.box(bodyRoot), root, neighbour_.box(root));
  while (!stack.empty() && best.distance > 0) {
    const NodePair item = stack.pop();
    if (item.gap >= best.distance) continue;
    if (item.isPair()) {
      tryPair(item.pair());
      continue;
    }
    const int before = stack.size();
    openLarger(body_, neighbour_, item, push);
    sortFrom(before, stack);
  }
  return best;
}

LeafPair PairSearch::anyNearerThan(const Matrix3d& R, const Vector3d& t, double below,
                                   LeafPair hint) const {
  const auto nearer = [&](LeafPair pair) {
    const Triangle3d a = posed(R, t, body_.corners(pair.body));
    const Triangle3d& b = neighbour_.corners(pair.neighbour);
    return Slab(a, b).gap < below && nearestPoints(a, b).squared < below * below;
  };
  if (hint.body >= 0 && nearer(hint)) return hint;
  NodeGap gap(body_, neighbour_, R, t);
  Stack stack(body_, neighbour_);
  const auto push = [&](BoxTree::Node i, const Box& a, BoxTree::Node j, const Box& b) {
    const double g = gap.between(i, a, j, b, below);
    if (g < below) stack.push({i, j, g});
  };
  const BoxTree::Node bodyRoot = body_.tree().root(), root = neighbour_.tree().root();
  push(bodyRoot, body_.box(bodyRoot), root, neighbour_.box(root));
  while (!stack.empty()) {
    const NodePair item = stack.pop();
    if (item.isPair()) {
      if (nearer(item.pair())) return item.pair();
      continue;
    }
    const int before = stack.size();
    openLarger(body_, neighbour_, item, push);
    sortFrom(before, stack);
  }
  return {};
}

Certificate PairSearch::certify(const MotionBound& motion, double apart, std::int64_t effort,
                                LeafPair hint) const {
  Certificate result;
  const auto pairHolds = [&](LeafPair pair) {
    const Triangle3d a = posed(motion.R, motion.t, body_.corners(pair.body));
    const Triangle3d& b = neighbour_.corners(pair.neighbour);
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
  NodeGap gap(body_, neighbour_, motion.R, motion.t);
  // Returns -1 if the nodes are proven to stay apart, otherwise their gap, which orders the search.
  const auto openGap = [&](BoxTree::Node i, const Box& a, BoxTree::Node j, const Box& b) {
    const double first = gap.boxes().inWorld(a, b);
    if (first - motion.reach >= apart) return -1.0;
    const double second = gap.boxes().inBody(a, b);
    if (second - motion.reach >= apart) return -1.0;
    if (first > apart &&
        first - motion.advance(gap.boxes().worldDirection(first), a.centre, a.half) >= apart)
      return -1.0;
    if (second > apart &&
        second - motion.advance(gap.boxes().bodyDirection(second), a.centre, a.half) >= apart)
      return -1.0;
    const double third = gap.betweenPlates(i, j);
    if (third - motion.reach >= apart) return -1.0;
    if (third > apart &&
        third - motion.advance(gap.plates().direction(), a.centre, a.half) >= apart)
      return -1.0;
    return std::max({first, second, third});
  };
  Stack stack(body_, neighbour_);
  const auto push = [&](BoxTree::Node i, const Box& a, BoxTree::Node j, const Box& b) {
    const double g = openGap(i, a, j, b);
    if (g >= 0) stack.push({i, j, g});
  };
  const BoxTree::Node bodyRoot = body_.tree().root(), root = neighbour_.tree().root();
  push(bodyRoot, body_.box(bodyRoot), root, neighbour_.box(root));
  while (!stack.empty()) {
    if (--effort < 0) return result;
    const NodePair item = stack.pop();
    if (item.isPair()) {
      if (!pairHolds(item.pair())) return result;
      continue;
    }
    const int before = stack.size();
    openLarger(body_, neighbour_, item, push);
    sortFrom(before, stack);  // the pair most likely to come too near is examined first
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

std::vector<LeafPair> PairSearch::pairsWithin(const Matrix3d& R, const Vector3d& t, double apart,
                                              std::size_t limit) const {
  std::vector<LeafPair> found;
  NodeGap gap(body_, neighbour_, R, t);
  const double beyond = std::nextafter(apart, HUGE_VAL);
  Stack stack(body_, neighbour_);
  const auto push = [&](BoxTree::Node i, const Box& a, BoxTree::Node j, const Box& b) {
    if (gap.between(i, a, j, b, beyond) < beyond) stack.push({i, j, 0});
  };
  const BoxTree::Node bodyRoot = body_.tree().root(), root = neighbour_.tree().root();
  push(bodyRoot, body_.box(bodyRoot), root, neighbour_.box(root));
  while (!stack.empty() && found.size() < limit) {
    const NodePair item = stack.pop();
    if (item.isPair()) {
      if (!(leafDistance(R, t, item.pair()).squared > apart * apart)) found.push_back(item.pair());
      continue;
    }
    openLarger(body_, neighbour_, item, push);
  }
  return found;
}

}  // namespace swept::clearance
