// SPDX-License-Identifier: LGPL-2.1-or-later
#include "crossings/motion_rays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "sampling/culling/swept_elements.h"

namespace swept {
namespace {

/// Groups with at most this many placements are not divided.
constexpr std::uint32_t kSmallGroup = 8;
/// Covers the rounding of all bounds, in mm per mm.
constexpr double kRounding = 1e-9;
/// A hit may lie beside its triangle by this part of the triangle's size (element_probe.cpp).
constexpr double kBeside = 1e-6;

/// A later hit must lie this far before the best one, as a share of the segment. Faces that slide
/// along themselves are hit at nearly the same place at every placement.
constexpr double kSame = 1e-6;

using Numbers = Eigen::Array<double, 12, 1>;

/// Returns the nine entries of the rotation, scaled by the radius of the body, and the place of its
/// centre. All twelve numbers are then lengths.
Numbers numbersOf(const Placement& placement, const Eigen::Vector3d& centre, double radius) {
  Numbers numbers;
  numbers << placement.rotation.reshaped().array() * radius, placement.apply(centre).array();
  return numbers;
}

struct Box {
  Eigen::Vector3d middle, half;
};

}  // namespace

MotionRays::MotionRays(const SamplerInput& input)
    : input_(input), triangles_(boxTreeOf(input.body.vertices, input.body.triangles)) {
  for (const Eigen::Vector3d& v : input.body.vertices) {
    radius_ = std::max(radius_, (v - triangles_.middle()).norm());
  }
  order_.resize(input.motion.placements.size());
  std::iota(order_.begin(), order_.end(), 0u);
  groups_.push_back({0, static_cast<std::uint32_t>(order_.size())});
  for (std::size_t group = 0; group < groups_.size(); ++group) divide(group);
}

/// Measures a group and divides it at the median of the number that varies most.
void MotionRays::divide(std::size_t group) {
  const auto& placements = input_.motion.placements;
  const auto at = [&](std::size_t k) {
    return numbersOf(placements[k], triangles_.middle(), radius_);
  };
  const auto first = order_.begin() + groups_[group].first,
             end = order_.begin() + groups_[group].end;
  Numbers low = Numbers::Constant(HUGE_VAL), high = -low;
  for (auto k = first; k != end; ++k) {
    const Numbers start = at(*k);
    const Numbers after = *k < input_.motion.steps() ? at(*k + 1) : start;
    low = low.min(start.min(after));
    high = high.max(start.max(after));
  }
  int widest = 0;
  (high - low).maxCoeff(&widest);
  const auto half = first + (end - first) / 2;
  const auto key = [&](std::uint32_t k) {
    return widest < 9 ? placements[k].rotation(widest % 3, widest / 3)
                      : placements[k].apply(triangles_.middle())[widest - 9];
  };
  std::nth_element(first, half, end, [&](std::uint32_t a, std::uint32_t b) {
    const double x = key(a), y = key(b);
    return x < y || (x == y && a < b);
  });
  Group& g = groups_[group];
  g.middle = *half;
  const Numbers centre = at(g.middle);
  const Numbers spread = (high - centre).max(centre - low) * (1 + kRounding);
  g.turnSpread = spread.head<9>().matrix().norm() / radius_;
  g.placeSpread = spread.tail<3>().matrix().norm();
  if (g.end - g.first <= kSmallGroup) return;
  const auto split = static_cast<std::uint32_t>(half - order_.begin());
  const std::uint32_t from = g.first, to = g.end;
  g.child = static_cast<std::int32_t>(groups_.size());
  groups_.push_back({from, split});
  groups_.push_back({split, to});
}

/// One search: goes down both trees at the same time.
class RaySearch {
 public:
  RaySearch(const MotionRays& rays, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
            double best, const MotionRays::Try& tryPair)
      : rays_(rays), input_(rays.input_), tryPair_(tryPair), best_(std::min(best - kSame, 1.0)) {
    const GridPlan& grid = input_.grid;
    from_ = grid.origin + from * grid.cell;
    to_ = grid.origin + to * grid.cell;
  }

  void group(std::size_t number, BoxTree::Node node, const Box& box) {
    const MotionRays::Group& g = rays_.groups_[number];
    const Segment segment = seenFrom(g.middle);
    if (!(enter(segment, box, reachOf(g, box)) < best_)) return;
    go(number, segment, node, box);
  }

 private:
  /// The segment as seen from the body at a placement.
  struct Segment {
    Eigen::Vector3d from, way;
  };
  Segment seenFrom(std::uint32_t placement) const {
    const Placement& p = input_.motion.placements[placement];
    const Eigen::Matrix3d back = p.rotation.transpose();
    return {back * (from_ - p.translation), back * (to_ - from_)};
  }
  double reachOf(const MotionRays::Group& g, const Box& box) const {
    const double arm = (box.middle - rays_.triangles_.middle()).norm() + box.half.norm();
    return g.placeSpread + g.turnSpread * arm + kBeside * box.half.norm() + kRounding * arm;
  }
  /// Returns the share of the segment up to the box, grown by `reach`. Returns infinity if the
  /// segment misses the box.
  static double enter(const Segment& segment, const Box& box, double reach) {
    double first = 0, last = 1;
    for (int axis = 0; axis < 3; ++axis) {
      const double half = box.half[axis] + reach, to = box.middle[axis] - segment.from[axis];
      const double way = segment.way[axis];
      if (std::abs(way) < 1e-300) {
        if (std::abs(to) > half) return HUGE_VAL;
        continue;
      }
      const double a = (to - half) / way, b = (to + half) / way;
      first = std::max(first, std::min(a, b));
      last = std::min(last, std::max(a, b));
    }
    return first <= last ? first : HUGE_VAL;
  }
  Box childBox(BoxTree::Node node, std::uint32_t lane) const {
    const BoxTree::FloatBox b = rays_.triangles_.childBoxes(node).box(static_cast<int>(lane));
    Box box;
    for (int axis = 0; axis < 3; ++axis) {
      const double low = b.low[axis], high = b.high[axis];
      box.middle[axis] = rays_.triangles_.middle()[axis] + (low + high) / 2;
      box.half[axis] = (high - low) / 2;
    }
    return box;
  }

  /// Looks at one group of placements and one node of triangles. Divides the larger of the two.
  void go(std::size_t number, const Segment& segment, BoxTree::Node node, const Box& box) {
    const MotionRays::Group& g = rays_.groups_[number];
    const bool byPlacements = node.isItem() || reachOf(g, box) > box.half.norm();
    if (byPlacements && g.child < 0) {
      for (std::uint32_t n = g.first; n < g.end; ++n) step(rays_.order_[n], node, box);
      return;
    }
    if (!byPlacements) {
      forChildren(
          node, [&](const Box& b) { return enter(segment, b, reachOf(g, b)); },
          [&](BoxTree::Node child, const Box& b) { go(number, segment, child, b); });
      return;
    }
    const std::size_t first = static_cast<std::size_t>(g.child);
    std::array<double, 2> at{};
    std::array<Segment, 2> seen;
    for (std::size_t n = 0; n < 2; ++n) {
      const MotionRays::Group& child = rays_.groups_[first + n];
      seen[n] = seenFrom(child.middle);
      at[n] = enter(seen[n], box, reachOf(child, box));
    }
    const std::size_t nearer = at[1] < at[0] ? 1 : 0;
    for (const std::size_t n : {nearer, 1 - nearer}) {
      if (at[n] < best_) go(first + n, seen[n], node, box);
    }
  }

  /// Calls use(child, box) for the children of a node that the segment enters before the best hit,
  /// the nearest first.
  template <class Enter, class Use>
  void forChildren(BoxTree::Node node, const Enter& enterBox, const Use& use) {
    std::array<Box, BoxTree::kWidth> boxes;
    std::array<double, BoxTree::kWidth> at;
    std::array<std::uint32_t, BoxTree::kWidth> order;
    std::size_t count = 0;
    for (std::uint32_t lane = 0; lane < rays_.triangles_.children(node); ++lane) {
      boxes[lane] = childBox(node, lane);
      at[lane] = enterBox(boxes[lane]);
      if (!(at[lane] < best_)) continue;
      std::size_t place = count++;
      for (; place > 0 && at[order[place - 1]] > at[lane]; --place) order[place] = order[place - 1];
      order[place] = lane;
    }
    for (std::size_t n = 0; n < count; ++n) {
      const std::uint32_t lane = order[n];
      if (at[lane] < best_) use(BoxTree::child(node, lane), boxes[lane]);
    }
  }

  /// Looks at one step, or at the last placement.
  void step(std::uint32_t k, BoxTree::Node node, const Box& box) {
    const Segment segment = seenFrom(k);
    const bool moves = k < input_.motion.steps();
    const MotionStep step = moves ? MotionStep(input_, k) : MotionStep();
    const Eigen::Matrix3d turn =
        moves ? Eigen::Matrix3d(step.turnBack.cwiseAbs().transpose()) : Eigen::Matrix3d::Identity();
    // Returns the share of the segment up to the box at the start or end of the step.
    const auto enterStep = [&](const Box& at) {
      if (!moves) return enter(segment, at, kBeside * at.half.norm());
      const Eigen::Vector3d travel = step.bend * at.middle + step.shift;
      const Eigen::Vector3d after = at.middle + travel;
      // The box stays within a ball that moves along a line. It misses the segment if it stays on
      // one side of the plane that contains the segment and the direction of this line.
      const Eigen::Vector3d across = segment.way.cross(travel);
      const double beside = across.dot(at.middle - segment.from);
      const double ball = at.half.norm() * (1 + kBeside) + kRounding * at.middle.norm();
      if (beside * beside > across.squaredNorm() * ball * ball) return HUGE_VAL;
      const Eigen::Vector3d half = turn * at.half;
      const Eigen::Vector3d low = (at.middle - at.half).cwiseMin(after - half);
      const Eigen::Vector3d high = (at.middle + at.half).cwiseMax(after + half);
      const Box hull{(low + high) / 2, (high - low) / 2};
      return enter(segment, hull, kBeside * hull.half.norm() + kRounding * at.middle.norm());
    };
    if (enterStep(box) < best_) triangles(k, node, enterStep);
  }

  template <class Enter>
  void triangles(std::uint32_t k, BoxTree::Node node, const Enter& enterBox) {
    if (node.isItem()) {
      const auto triangle = static_cast<std::uint32_t>(rays_.triangles_.item(node.index));
      best_ = std::min(best_, tryPair_(triangle, k) - kSame);
      return;
    }
    forChildren(node, enterBox,
                [&](BoxTree::Node child, const Box&) { triangles(k, child, enterBox); });
  }

  const MotionRays& rays_;
  const SamplerInput& input_;
  const MotionRays::Try& tryPair_;
  Eigen::Vector3d from_, to_;
  double best_;  // the search goes on only before this share of the segment
};

void MotionRays::search(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double best,
                        const Try& tryPair) const {
  const BoxTree::Bounds& bounds = triangles_.bounds();
  const Box whole{(bounds.low + bounds.high) / 2, (bounds.high - bounds.low) / 2};
  RaySearch(*this, from, to, best, tryPair).group(0, triangles_.root(), whole);
}

}  // namespace swept
