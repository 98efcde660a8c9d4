// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sampling/dense/placement_space.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>

#include "motion/step_path.h"

namespace swept::dense {
namespace {

// Points per leaf. Testing eight points costs about as much as testing the boxes of one more level.
constexpr std::uint32_t kLeaf = 8;

Placement meanOf(const std::vector<Placement>& placements, const Eigen::Vector3d& centre) {
  // For small turns the mean rotation is the rotation nearest to the mean of the matrices.
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  for (const Placement& p : placements) {
    sum += p.rotation;
    at += p.apply(centre);
  }
  const auto count = static_cast<double>(placements.size());
  Placement mean;
  mean.rotation = Eigen::Quaterniond(Eigen::Matrix3d(sum / count)).normalized().toRotationMatrix();
  mean.translation = at / count - mean.rotation * centre;
  return mean;
}

}  // namespace

PlacementSpace::PlacementSpace(const TriMesh& body, const std::vector<Placement>& placements,
                               Wanted wanted) {
  const Sphere ball = boundingSphere(body);
  centre_ = ball.centre;
  radius_ = ball.radius;
  mean_ = meanOf(placements, centre_);
  const Eigen::Vector3d middle = mean_.apply(centre_);
  points_.resize(placements.size());
  for (std::size_t i = 0; i < placements.size(); ++i) {
    const Eigen::Vector3d shift = placements[i].apply(centre_) - middle;
    const Eigen::AngleAxisd turn(
        Eigen::Quaterniond(placements[i].rotation * mean_.rotation.transpose()).normalized());
    const Eigen::Vector3d w = turn.axis() * turn.angle();
    turn_ = std::max(turn_, w.norm());
    reach_ = std::max(reach_, shift.norm() + w.norm() * radius_);
    for (int axis = 0; axis < 3; ++axis) {
      points_[i][axis] = static_cast<float>(shift[axis]);
      points_[i][axis + 3] = static_cast<float>(w[axis] * radius_);
    }
  }
  remainder_ = radius_ * turn_ * turn_ / 2;
  if (wanted == kExtentOnly) return;
  order_.resize(points_.size());
  std::iota(order_.begin(), order_.end(), 0u);
  build(0, static_cast<std::uint32_t>(order_.size()));
  sorted_.reserve(order_.size());
  for (const std::uint32_t i : order_) sorted_.push_back(points_[i]);
}

std::uint32_t PlacementSpace::build(std::uint32_t begin, std::uint32_t end) {
  const auto self = static_cast<std::uint32_t>(nodes_.size());
  Node node;
  node.begin = begin;
  node.end = end;
  node.low.fill(1e30f);
  node.high.fill(-1e30f);
  for (std::uint32_t i = begin; i < end; ++i) {
    for (std::size_t a = 0; a < 6; ++a) {
      node.low[a] = std::min(node.low[a], points_[order_[i]][a]);
      node.high[a] = std::max(node.high[a], points_[order_[i]][a]);
    }
  }
  nodes_.push_back(node);
  if (end - begin <= kLeaf) {
    std::sort(order_.begin() + begin, order_.begin() + end);
    return self;
  }
  std::size_t widest = 0;
  for (std::size_t a = 1; a < 6; ++a) {
    if (node.high[a] - node.low[a] > node.high[widest] - node.low[widest]) widest = a;
  }
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&](std::uint32_t x, std::uint32_t y) {
                     const float px = points_[x][widest], py = points_[y][widest];
                     return px != py ? px < py : x < y;
                   });
  build(begin, middle);
  const std::uint32_t right = build(middle, end);
  nodes_[self].right = right;
  return self;
}

Point6 PlacementSpace::gradient(const Eigen::Vector3d& x, const Eigen::Vector3d& n) const {
  const Eigen::Vector3d worldNormal = mean_.rotation * n;
  const Eigen::Vector3d lever =
      (mean_.rotation * (x - centre_)).cross(worldNormal) / (radius_ > 0 ? radius_ : 1.0);
  Point6 g;
  for (int axis = 0; axis < 3; ++axis) {
    g[axis] = static_cast<float>(worldNormal[axis]);
    g[axis + 3] = static_cast<float>(lever[axis]);
  }
  return g;
}

/// Visits leaves, best branches first. Descends into a branch only if isWanted(bound of the
/// branch).
template <class IsWanted, class Visit>
void PlacementSpace::descend(const Point6& g, const IsWanted& isWanted, const Visit& visit) const {
  struct Open {
    std::uint32_t node;
    float bound;
  };
  std::array<Open, 64> stack;
  std::size_t open = 0;
  const Split split(g);
  stack[open++] = {0, bound(nodes_[0], split)};
  while (open > 0) {
    const Open top = stack[--open];
    if (!isWanted(top.bound)) continue;
    const Node& node = nodes_[top.node];
    if (node.right == 0) {
      visit(node);
      continue;
    }
    const Open left{top.node + 1, bound(nodes_[top.node + 1], split)};
    const Open right{node.right, bound(nodes_[node.right], split)};
    const bool leftFirst = left.bound >= right.bound;
    stack[open++] = leftFirst ? right : left;
    stack[open++] = leftFirst ? left : right;
  }
}

PlacementSpace::Best PlacementSpace::support(const Point6& g, std::uint32_t guess) const {
  constexpr float kRounding = 1e-5f;  // mm: bounds and dot products are summed in different orders
  Best best{guess, dot(g, points_[guess])};
  const auto isWanted = [&](float bound) { return bound + kRounding >= best.advance; };
  descend(g, isWanted, [&](const Node& leaf) {
    for (std::uint32_t i = leaf.begin; i < leaf.end; ++i) {
      const float advance = dot(g, sorted_[i]);
      if (advance > best.advance || (advance == best.advance && order_[i] < best.placement)) {
        best = {order_[i], advance};
      }
    }
  });
  return best;
}

void PlacementSpace::above(const Point6& g, float minAdvance, std::size_t maxCount,
                           std::vector<Best>& out) const {
  out.clear();
  const auto isWanted = [&](float bound) { return bound >= minAdvance && out.size() < maxCount; };
  descend(g, isWanted, [&](const Node& leaf) {
    for (std::uint32_t i = leaf.begin; i < leaf.end && out.size() < maxCount; ++i) {
      const float advance = dot(g, sorted_[i]);
      if (advance > minAdvance) out.push_back({order_[i], advance});
    }
  });
}

}  // namespace swept::dense
