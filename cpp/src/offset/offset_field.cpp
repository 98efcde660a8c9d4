// SPDX-License-Identifier: LGPL-2.1-or-later
#include "offset/offset_field.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"

namespace swept::offset {
namespace {

const double kHalfDiagonal = std::sqrt(3.0) / 2;

/// Returns the reach at which a search about the centre of a node may stop. If `distance` is larger
/// than the radius of the node, this reach proves that the whole node lies inside the offset
/// surface. Otherwise no such proof is possible, and the node counts as mixed.
double enoughFor(double distance, double radius) {
  return distance > radius ? distance - radius : distance + radius;
}

Eigen::Vector3d middleOf(const std::array<std::int32_t, 3>& low, std::int32_t size) {
  return Eigen::Vector3d(low[0], low[1], low[2]) + Eigen::Vector3d::Constant((size - 1) / 2.0);
}

/// Calls use(low) for the eight children of a node. `half`: the size of the children, half of that
/// of the node.
template <class Use>
void forHalves(const std::array<std::int32_t, 3>& low, std::int32_t half, const Use& use) {
  for (int c = 0; c < 8; ++c) {
    use({low[0] + (c & 1 ? half : 0), low[1] + (c & 2 ? half : 0), low[2] + (c & 4 ? half : 0)});
  }
}

}  // namespace

OffsetField::OffsetField(const CoverSearch& tree, double distance, const GridPlan& grid,
                         RunContext& run)
    : tree_(tree), distance_(distance), points_(grid.points) {
  std::int32_t size = kBlock;
  for (int axis = 0; axis < 3; ++axis) {
    blocks_[axis] = static_cast<std::size_t>((points_[axis] + kBlock - 1) / kBlock);
    while (size < points_[axis]) size *= 2;
  }
  blockOf_.assign(blocks_[0] * blocks_[1] * blocks_[2], kOutside);
  std::vector<Node> nodes{{{0, 0, 0}, -1}};
  for (; size >= kBlock; size /= 2) nodes = refineTo(size, nodes, run);
  gaps_.resize(nodes.size());
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    setBlocks(nodes[n], kBlock, static_cast<std::int32_t>(n));
  }
  parallelBlocks(nodes.size(), 8, [&](std::size_t begin, std::size_t end) {
    run.checkpoint(Phase::Sampling, begin, nodes.size());
    for (std::size_t n = begin; n < end; ++n) fill(nodes[n], kBlock, gaps_[n]);
  });
}

/// Classifies nodes of this size as outside, inside or mixed. Returns the mixed nodes: their
/// children, or the nodes themselves if they have the size of a block.
std::vector<OffsetField::Node> OffsetField::refineTo(std::int32_t size,
                                                     const std::vector<Node>& nodes,
                                                     RunContext& run) {
  // The radius includes one cell more. So if a node lies on one side, the surface does not cross
  // the edges from this node to its neighbours, either.
  const double radius = kHalfDiagonal * (size - 1) + 1;
  std::vector<std::int8_t> kinds(nodes.size(), 0);
  std::vector<std::int32_t> hints(nodes.size(), -1);
  parallelBlocks(nodes.size(), 64, [&](std::size_t begin, std::size_t end) {
    run.checkpoint(Phase::Sampling);
    for (std::size_t n = begin; n < end; ++n) {
      const CoverSearch::Nearest found =
          tree_.nearest(middleOf(nodes[n].low, size), distance_ + radius, nodes[n].hint,
                        enoughFor(distance_, radius));
      hints[n] = found.triangle;
      if (found.triangle < 0) kinds[n] = kOutside;
      if (found.triangle >= 0 && found.reach <= distance_ - radius) kinds[n] = kInside;
    }
  });
  std::vector<Node> next;
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    if (kinds[n] != 0) {
      if (kinds[n] == kInside) setBlocks(nodes[n], size, kInside);
      continue;
    }
    if (size == kBlock) {
      next.push_back({nodes[n].low, hints[n]});
      continue;
    }
    forHalves(nodes[n].low, size / 2, [&](const std::array<std::int32_t, 3>& low) {
      if (low[0] < points_[0] && low[1] < points_[1] && low[2] < points_[2]) {
        next.push_back({low, hints[n]});
      }
    });
  }
  return next;
}

void OffsetField::setBlocks(const Node& node, std::int32_t size, std::int32_t kind) {
  std::array<std::size_t, 3> begin, end;
  for (int axis = 0; axis < 3; ++axis) {
    begin[axis] = static_cast<std::size_t>(node.low[axis] / kBlock);
    end[axis] = std::min(begin[axis] + static_cast<std::size_t>(size / kBlock), blocks_[axis]);
  }
  for (std::size_t i = begin[0]; i < end[0]; ++i) {
    for (std::size_t j = begin[1]; j < end[1]; ++j) {
      for (std::size_t k = begin[2]; k < end[2]; ++k) {
        blockOf_[(i * blocks_[1] + j) * blocks_[2] + k] = kind;
      }
    }
  }
}

/// Computes the gaps of all lattice points of a node that is a block or a part of a block.
void OffsetField::fill(const Node& node, std::int32_t size, Gaps& gaps) const {
  const double radius = kHalfDiagonal * 2 * (size - 1) / 2;
  Node at = node;
  if (size < kBlock) {
    const CoverSearch::Nearest found = tree_.nearest(
        middleOf(node.low, size), distance_ + radius + 1, node.hint, enoughFor(distance_, radius));
    at.hint = found.triangle;
    const double gap = found.reach - distance_;
    if (size == 1 || gap > radius || gap <= -radius) {
      const double least = gap > 0 ? gap - radius : gap + radius;
      for (std::int32_t i = 0; i < size; ++i) {
        for (std::int32_t j = 0; j < size; ++j) {
          for (std::int32_t k = 0; k < size; ++k) {
            gaps[local(node.low[0] + i, node.low[1] + j, node.low[2] + k)] =
                static_cast<float>(least);
          }
        }
      }
      return;
    }
  }
  forHalves(at.low, size / 2, [&](const std::array<std::int32_t, 3>& low) {
    fill({low, at.hint}, size / 2, gaps);
  });
}

}  // namespace swept::offset
