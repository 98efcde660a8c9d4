// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sampling/culling/step_blocks.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>

#include "base/parallel.h"
#include "base/sort_unique.h"
#include "base/timer.h"
#include "grid/snap.h"
#include "sampling/culling/inside_map.h"

namespace swept {
namespace {

constexpr double kRounding = 1 + 1e-9;  ///< covers the rounding of the bounds
constexpr double kSnapReach = 1e-4;     ///< cells: more than snapping can move a point
/// Largest and smallest size of a group of placements, in cells.
constexpr double kMaxGroup = 2, kMinGroup = 1e-3;
/// cells: in groups of at most this size, single faces are tested, too.
constexpr double kFaceGroup = 0.5;
/// Grouping saves time only if groups have at least this many placements on average.
constexpr std::size_t kWorthGroup = 8;

/// Returns the groups of some placements, in ascending order.
std::vector<std::uint32_t> groupsOf(const std::vector<PlacementRange>& ranges,
                                    const std::vector<std::uint32_t>& groupOf) {
  std::vector<std::uint32_t> groups;
  for (const PlacementRange& range : ranges) {
    for (std::size_t k = range.begin; k < range.end; ++k) groups.push_back(groupOf[k]);
  }
  sortUnique(groups);
  return groups;
}

}  // namespace

PlacementBounds::PlacementBounds(const SamplerInput& input, const FaceClusters& clusters)
    : input_(input) {
  Eigen::AlignedBox3d box;
  for (const FaceCluster& c : clusters.clusters) box.extend(c.centre);
  centre_ = box.center();
  for (const FaceCluster& c : clusters.clusters) {
    radius_ = std::max(radius_, (c.centre - centre_).norm() + c.radius);
  }
}

PlacementBounds::Box PlacementBounds::boxOf(std::size_t k) const {
  const auto one = [&](std::size_t at) {
    const Placement p = input_.grid.toGrid(input_.motion.placements[at]);
    Box box;
    box.low << p.rotation.reshaped().array(), p.apply(centre_).array();
    box.high = box.low;
    return box;
  };
  Box box = one(k);
  if (k < input_.motion.steps()) box.add(one(k + 1));
  return box;
}

PlacementBlock PlacementBounds::blockOf(const Box& box) {
  const Box::Map middle = (box.low + box.high) / 2, half = (box.high - box.low) / 2;
  PlacementBlock block;
  block.turn = middle.head<9>().matrix().reshaped(3, 3);
  block.position = middle.tail<3>().matrix();
  block.turnSpread = half.head<9>().matrix().norm() * kRounding;
  block.positionSpread = half.tail<3>().matrix().norm() * kRounding;
  return block;
}

bool PlacementBounds::shows(const PlacementBlock& block, const FaceCluster& cluster) const {
  const Eigen::Vector3d arm = cluster.centre - centre_;
  const double reach = cluster.radius / input_.grid.cell * kRounding + block.positionSpread +
                       block.turnSpread * (arm.norm() + cluster.radius) + kSnapReach;
  if (reach > 0.5 && !hasInside()) return true;
  const Eigen::Array3d at = (block.turn * arm + block.position).array();
  const Eigen::Array3d low = at - reach, high = at + reach;
  return meetsLines(low.floor().eval(), high.floor().eval()) &&
         !(hasInside() && input_.inside->hides(low, high));
}

bool PlacementBounds::shows(const PlacementBlock& block, std::uint32_t face) const {
  std::array<Eigen::Vector3d, 3> corner;
  double farthest = 0;
  for (std::size_t n = 0; n < 3; ++n) {
    const Eigen::Vector3d arm = input_.body.vertices[input_.body.triangles[face][n]] - centre_;
    farthest = std::max(farthest, arm.norm());
    corner[n] = block.turn * arm + block.position;
  }
  const double reach = block.positionSpread + block.turnSpread * farthest + kSnapReach;
  return !input_.inside->hides(corner, reach);
}

PlacementGroups::PlacementGroups(const SamplerInput& input, const FaceClusters& clusters,
                                 RunContext& run, Trial* trial) {
  if (input.inside == nullptr) return;
  const PlacementBounds bounds(input, clusters);
  std::vector<PlacementBounds::Box> boxes(input.motion.placements.size());
  parallelBlocks(boxes.size(), 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) boxes[k] = bounds.boxOf(k);
  });
  // Smaller groups hide more clusters, but there are more groups. A group only tests the clusters
  // that the larger group around it shows.
  for (double cells = kMaxGroup; cells > kMinGroup; cells /= 2) {
    std::vector<std::uint32_t> groupOf;
    const auto groups = group(boxes, cells, bounds.radius(), groupOf);
    if (groups.size() * kWorthGroup > boxes.size()) break;
    std::vector<std::uint32_t> around(groups.size());
    for (std::size_t k = 0; k < groupOf_.size(); ++k) around[groupOf[k]] = groupOf_[k];
    if (shown_.empty()) shown_.push_back(allClusters(clusters, input.clusterParts));
    std::vector<ShownClusters> shown(groups.size());
    std::vector<std::uint32_t> decided(groups.size());
    std::iota(decided.begin(), decided.end(), 0u);
    if (trial != nullptr) decided = groupsOf(trial->only, groupOf);
    const double start = trial != nullptr ? threadSeconds() : 0;
    parallelFor(decided.size(), [&](std::size_t n) {
      run.checkpoint(Phase::Sampling);
      const std::uint32_t g = decided[n];
      const PlacementBlock block = PlacementBounds::blockOf(groups[g]);
      for (const ShownCluster& s : shown_[around[g]]) {
        const FaceCluster& cluster = clusters.clusters[s.cluster];
        if (!bounds.shows(block, cluster)) continue;
        std::uint32_t faces = s.faces;
        for (std::uint32_t f = 0; f < cluster.faceCount && cells <= kFaceGroup; ++f) {
          if (s.shows(f) && !bounds.shows(block, clusters.faces[cluster.firstFace + f])) {
            faces &= ~(1u << f);
          }
        }
        if (cells <= kFaceGroup && cluster.faceCount < 32) faces &= (1u << cluster.faceCount) - 1;
        if (faces != 0) shown[g].push_back({s.cluster, faces});
      }
    });
    if (trial != nullptr && !decided.empty()) {
      const double others = static_cast<double>(groups.size() - decided.size());
      trial->secondsOfOthers +=
          (threadSeconds() - start) * others / static_cast<double>(decided.size());
    }
    shown_ = std::move(shown);
    groupOf_ = std::move(groupOf);
  }
}

std::vector<PlacementBounds::Box> PlacementGroups::group(
    const std::vector<PlacementBounds::Box>& boxes, double cells, double radius,
    std::vector<std::uint32_t>& groupOf) {
  using Key = std::array<std::int32_t, 12>;
  struct KeyHash {
    std::size_t operator()(const Key& key) const {
      std::uint64_t h = 0;
      for (const std::int32_t x : key) {
        h = (h ^ static_cast<std::uint32_t>(x)) * 0x9e3779b97f4a7c15u;
        h ^= h >> 29;
      }
      return h;
    }
  };
  std::unordered_map<Key, std::uint32_t, KeyHash> numbers;
  std::vector<PlacementBounds::Box> groups;
  groupOf.resize(boxes.size());
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    Key key;
    for (int n = 0; n < 12; ++n) {
      key[n] =
          static_cast<std::int32_t>(std::floor(boxes[k].low[n] * (n < 9 ? radius : 1) / cells));
    }
    const auto [at, isNew] = numbers.try_emplace(key, static_cast<std::uint32_t>(groups.size()));
    if (isNew) groups.emplace_back();
    groups[at->second].add(boxes[k]);
    groupOf[k] = at->second;
    if (groups.size() * kWorthGroup > boxes.size()) break;
  }
  return groups;
}

StepBlocks::StepBlocks(const SamplerInput& input, const FaceClusters& clusters,
                       const PlacementGroups& groups, std::size_t begin, std::size_t end)
    : clusters_(clusters),
      groups_(groups),
      bounds_(input, clusters),
      parts_(input.clusterParts),
      begin_(begin),
      end_(end) {
  for (const FaceCluster& c : clusters.clusters) {
    narrows_ |= bounds_.hasInside() || c.radius < 0.5 * input.grid.cell;
  }
  below_.resize(1 + kMaxLevels);
  if (!groups.empty()) narrows_ = false;  // all groups have been tested already
  if (!narrows_) return;
  std::vector<PlacementBounds::Box> boxes;
  boxes.reserve(end - begin);
  for (std::size_t k = begin; k < end; ++k) boxes.push_back(bounds_.boxOf(k));
  const auto blocksOf = [&] {
    std::vector<PlacementBlock> blocks;
    blocks.reserve(boxes.size());
    for (const PlacementBounds::Box& box : boxes) blocks.push_back(PlacementBounds::blockOf(box));
    return blocks;
  };
  single_ = blocksOf();
  constexpr std::size_t kChildren = std::size_t{1} << kShift;
  while (levels_.size() < kMaxLevels && boxes.size() > kChildren) {
    for (std::size_t n = 0; n < boxes.size(); ++n) {
      if (n % kChildren == 0) {
        boxes[n / kChildren] = boxes[n];
      } else {
        boxes[n / kChildren].add(boxes[n]);
      }
    }
    boxes.resize((boxes.size() + kChildren - 1) / kChildren);
    levels_.push_back(blocksOf());
  }
}

const ShownClusters& StepBlocks::narrow(std::size_t at, const ShownClusters& above) {
  if (!groups_.empty() && parts_ > 0) return groups_.shownAt(begin_ + at);
  if (!narrows_) return above;
  ShownClusters& shown = below_[0];
  shown.clear();
  for (const ShownCluster& s : above) {
    if (bounds_.shows(single_[at], clusters_.clusters[s.cluster])) shown.push_back(s);
  }
  return shown;
}

}  // namespace swept
