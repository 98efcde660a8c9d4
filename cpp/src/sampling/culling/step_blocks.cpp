// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sampling/culling/step_blocks.h"

#include <algorithm>
#include <cmath>

#include "sampling/culling/inside_map.h"

namespace swept {
namespace {

/// Covers the rounding of the bounds.
constexpr double kRoom = 1 + 1e-9;
constexpr double kSnapReach = 1e-4;  ///< cells: more than snapping moves a corner

}  // namespace

/// Boxes of the nine numbers of a matrix and the three of a vector, and maxima.
struct StepBlocks::Boxes {
  using Map = Eigen::Array<double, 12, 1>;
  Map placesLow = Map::Constant(1e300), placesHigh = -placesLow;
  Map stepsLow = Map::Constant(1e300), stepsHigh = -stepsLow;
  double angle = 0, anglePerLength = 0, perLength = 0;
  bool moves = true, hasFirst = false, hasLast = false;

  static Map mapOf(const Eigen::Matrix3d& m, const Eigen::Vector3d& v) {
    Map map;
    map << m.reshaped().array(), v.array();
    return map;
  }
  void addPlace(const Map& map) {
    placesLow = placesLow.min(map);
    placesHigh = placesHigh.max(map);
  }
  void addStep(const Map& map) {
    stepsLow = stepsLow.min(map);
    stepsHigh = stepsHigh.max(map);
  }
  void add(const Boxes& other) {
    placesLow = placesLow.min(other.placesLow);
    placesHigh = placesHigh.max(other.placesHigh);
    stepsLow = stepsLow.min(other.stepsLow);
    stepsHigh = stepsHigh.max(other.stepsHigh);
    angle = std::max(angle, other.angle);
    anglePerLength = std::max(anglePerLength, other.anglePerLength);
    perLength = std::max(perLength, other.perLength);
    moves &= other.moves;
    hasFirst |= other.hasFirst;
    hasLast |= other.hasLast;
  }
};

StepBlocks::StepBlocks(const SamplerInput& input, const FaceClusters& clusters, std::size_t begin,
                       std::size_t end)
    : input_(input),
      clusters_(clusters),
      begin_(begin),
      direction_(clusters.clusters.size(), 0),
      depth_(clusters.clusters.size(), kNotAsked) {
  Eigen::AlignedBox3d box;
  for (const FaceCluster& c : clusters.clusters) box.extend(c.centre);
  centre_ = box.center();
  for (const FaceCluster& c : clusters.clusters) {
    radius_ = std::max(radius_, (c.centre - centre_).norm() + c.radius);
  }
  std::vector<Boxes> boxes;
  boxes.reserve(end - begin);
  for (std::size_t k = begin; k < end; ++k) boxes.push_back(boxesOf(k));
  for (std::size_t level = 0;; ++level) {
    std::vector<Block>& blocks = levels_.emplace_back();
    blocks.reserve(boxes.size());
    for (const Boxes& b : boxes) blocks.push_back(blockOf(b));
    if (level == kTopLevel || boxes.size() == 1) break;
    for (std::size_t n = 0; n < boxes.size(); n += 2) {
      boxes[n / 2] = boxes[n];
      if (n + 1 < boxes.size()) boxes[n / 2].add(boxes[n + 1]);
    }
    boxes.resize((boxes.size() + 1) / 2);
  }
  below_.resize(levels_.size());
}

/// The placement k, the step that starts there, and how the step before it moves.
StepBlocks::Boxes StepBlocks::boxesOf(std::size_t k) const {
  const auto& placements = input_.motion.placements;
  const std::size_t steps = input_.motion.steps();
  Boxes boxes;
  boxes.hasFirst = k == 0;
  boxes.hasLast = k + 1 == placements.size();
  for (std::size_t at = k; at <= std::min(k + 1, std::max(k, steps)); ++at) {
    const Placement p = input_.grid.toGrid(placements[at]);
    boxes.addPlace(Boxes::mapOf(p.rotation, p.apply(centre_)));
  }
  for (std::size_t step = k > 0 ? k - 1 : 0; step <= k && step < steps; ++step) {
    const Placement &p = placements[step], &q = placements[step + 1];
    const Eigen::Matrix3d bend = p.rotation.transpose() * q.rotation - Eigen::Matrix3d::Identity();
    const Eigen::Vector3d way =
        bend * centre_ + p.rotation.transpose() * (q.translation - p.translation);
    const double angle = bend.norm() / std::sqrt(2.0) * kRoom;
    const double length = way.norm() + angle * radius_;
    if (!(length > 0)) {
      boxes.moves = false;
      continue;
    }
    boxes.addStep(Boxes::mapOf(bend / length, way / length));
    boxes.angle = std::max(boxes.angle, angle);
    boxes.anglePerLength = std::max(boxes.anglePerLength, angle / length);
    boxes.perLength = std::max(boxes.perLength, 1 / length);
  }
  return boxes;
}

StepBlocks::Block StepBlocks::blockOf(const Boxes& boxes) {
  Block block;
  const auto split = [](const Boxes::Map& low, const Boxes::Map& high, Eigen::Matrix3d& matrix,
                        Eigen::Vector3d& vector, double& ofMatrix, double& ofVector) {
    const Boxes::Map middle = (low + high) / 2, half = (high - low) / 2;
    matrix = middle.head<9>().matrix().reshaped(3, 3);
    vector = middle.tail<3>().matrix();
    ofMatrix = half.head<9>().matrix().norm() * kRoom;
    ofVector = half.tail<3>().matrix().norm() * kRoom;
  };
  split(boxes.placesLow, boxes.placesHigh, block.turn, block.place, block.turnSpread,
        block.placeSpread);
  block.moves = boxes.moves && boxes.perLength > 0;
  if (block.moves) {
    split(boxes.stepsLow, boxes.stepsHigh, block.bend, block.way, block.bendSpread,
          block.waySpread);
  }
  block.angle = boxes.angle;
  block.anglePerLength = boxes.anglePerLength;
  block.perLength = boxes.perLength;
  block.hasFirst = boxes.hasFirst;
  block.hasLast = boxes.hasLast;
  return block;
}

bool StepBlocks::isHidden(const Block& block, const FaceCluster& cluster) const {
  const Eigen::Vector3d arm = cluster.centre - centre_;
  const double reach = cluster.radius / input_.grid.cell * kRoom + block.placeSpread +
                       block.turnSpread * (arm.norm() + cluster.radius) + kSnapReach;
  const Eigen::Array3d at = (block.turn * arm + block.place).array();
  return input_.inside->hides(at - reach, at + reach);
}

/// As FaceDirections decides for a single step, with the spread of the steps in the margin.
int StepBlocks::directionOf(const Block& block, const FaceCluster& cluster) const {
  if (!block.moves) return 0;
  const Eigen::Vector3d arm = cluster.centre - centre_;
  const Eigen::Vector3d d = block.bend * arm + block.way;
  const double along = cluster.axis.dot(d), length = d.norm();
  const double across = std::sqrt(std::max(0.0, length * length - along * along));
  const double least = std::abs(along) * cluster.cosCone - across * cluster.sinCone;
  if (least <= 0) return 0;
  const double apart = block.waySpread + block.bendSpread * arm.norm();
  const double spread = block.anglePerLength * cluster.radius;
  const double travel = length + apart + spread;
  const double margin = apart + spread +
                        travel * (block.angle + block.angle * block.angle + kNormalRounding +
                                  snapAngle(cluster.minHeight, input_.grid.cell)) +
                        4 * kSnapCells * input_.grid.cell * block.perLength;
  return least > margin * kRoom ? (along > 0 ? 1 : -1) : 0;
}

void StepBlocks::narrow(std::size_t level, std::size_t at, const LivePieces& above) {
  const Block& block = levels_[level][at];
  LivePieces& live = below_[level];
  live.clusters.clear();
  live.borders.clear();
  const bool mayHide = input_.inside != nullptr;
  // The directions of a single step are decided face by face where it is sampled.
  const bool mayDirect = input_.cull && level > 0;
  const auto hidden = [&](std::uint32_t c) {
    if (depth_[c] == kNotAsked)
      depth_[c] = isHidden(block, clusters_.clusters[c]) ? kHidden : kShown;
    return depth_[c] == kHidden;
  };
  for (const std::uint32_t c : above.clusters) {
    if (mayHide && hidden(c)) continue;
    if (mayDirect && direction_[c] == 0) {
      direction_[c] = static_cast<std::int8_t>(directionOf(block, clusters_.clusters[c]));
      if (direction_[c] != 0) decided_.push_back(c);
    }
    // Within the block each copy lies between two steps of one direction.
    const int way = direction_[c];
    const bool enclosed =
        way != 0 && (!block.hasFirst || faceIsEnclosed(0, way, false, true, input_.orientable)) &&
        (!block.hasLast || faceIsEnclosed(way, 0, true, false, input_.orientable));
    if (!enclosed) live.clusters.push_back(c);
  }
  for (const std::uint32_t b : above.borders) {
    const FaceClusters::Border& border = clusters_.borders[b];
    if (border.right >= 0) {
      const auto left = static_cast<std::uint32_t>(border.left);
      const int l = direction_[left], r = direction_[static_cast<std::size_t>(border.right)];
      if (l != 0 && l == (border.opposed ? -r : r)) continue;
      if (mayHide && hidden(left)) continue;
    }
    live.borders.push_back(b);
  }
  if (!mayHide) return;
  for (const std::uint32_t c : above.clusters) depth_[c] = kNotAsked;
  for (const std::uint32_t b : above.borders) {
    depth_[static_cast<std::size_t>(clusters_.borders[b].left)] = kNotAsked;
  }
}

}  // namespace swept
