// SPDX-License-Identifier: LGPL-2.1-or-later
#include "grid/plan_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "base/accuracy_text.h"
#include "base/number_text.h"
#include "base/parallel.h"
#include "geometry/box_tree.h"

namespace swept {
namespace {

/// Bounding box of the body in some placements, by branch and bound in a tree of the vertices: a
/// node is skipped if its box does not reach beyond the box found so far. Each further placement
/// then takes few steps, because hardly any vertex is farther out than all before.
class SweptBox {
 public:
  SweptBox(const TriMesh& body, const BoxTree& tree) : body_(body), tree_(tree) {}

  void add(const Placement& p) {
    for (int axis = 0; axis < 3; ++axis) {
      for (const double side : {-1.0, 1.0}) {
        Query query{p, axis, side, side * p.rotation.row(axis), 0, 0};
        query.shift = query.direction.dot(tree_.middle()) + side * p.translation[axis];
        query.slack = kSlack * (tree_.middle().norm() + std::abs(p.translation[axis]) +
                                (tree_.bounds().high - tree_.bounds().low).norm());
        double& edge = (side < 0 ? low_ : high_)[axis];
        double farthest = side * edge;
        search(query, tree_.root(), farthest);
        edge = side * farthest;
      }
    }
  }
  void add(const SweptBox& other) {
    low_ = low_.cwiseMin(other.low_);
    high_ = high_.cwiseMax(other.high_);
  }
  Eigen::AlignedBox3d box() const { return {low_, high_}; }

 private:
  static constexpr double kSlack = 1e-12;  // covers rounding
  struct Query {
    const Placement& placement;
    int axis;
    double side;
    Eigen::RowVector3d direction;  // of the world axis, in coordinates of the body
    double shift, slack;           // mm
  };

  void search(const Query& query, BoxTree::Node node, double& farthest) const {
    if (node.isItem()) {
      const Eigen::Vector3d& v = body_.vertices[tree_.item(node.index)];
      farthest = std::max(farthest, query.side * query.placement.apply(v)[query.axis]);
      return;
    }
    const BoxTree::Group& boxes = tree_.childBoxes(node);
    std::array<std::pair<double, std::uint32_t>, BoxTree::kWidth> reach;
    const std::uint32_t children = tree_.children(node);
    for (std::uint32_t c = 0; c < children; ++c) {
      double sum = query.shift + query.slack;
      for (int k = 0; k < 3; ++k) {
        const double d = query.direction[k];
        sum += d * static_cast<double>(d < 0 ? boxes.low[k][c] : boxes.high[k][c]);
      }
      reach[c] = {-sum, c};
    }
    std::sort(reach.begin(), reach.begin() + children);
    for (std::uint32_t c = 0; c < children && -reach[c].first > farthest; ++c) {
      search(query, BoxTree::child(node, reach[c].second), farthest);
    }
  }

  const TriMesh& body_;
  const BoxTree& tree_;
  Eigen::Vector3d low_ = Eigen::Vector3d::Constant(HUGE_VAL), high_ = -low_;
};

}  // namespace

Eigen::AlignedBox3d sweptBox(const TriMesh& body, const Motion& motion, RunContext& run) {
  const BoxTree tree(body.vertices.size(), [&](std::size_t v) {
    return BoxTree::Bounds{body.vertices[v], body.vertices[v]};
  });
  // Some placements from all over the motion give a large box, which shortens the other searches.
  SweptBox whole(body, tree);
  const std::size_t n = motion.placements.size(), stride = n / 64 + 1;
  for (std::size_t k = 0; k < n; k += stride) whole.add(motion.placements[k]);
  constexpr std::size_t kBlock = 512;
  std::vector<SweptBox> parts(n / kBlock + 1, whole);
  parallelBlocks(n, kBlock, [&](std::size_t begin, std::size_t end) {
    run.checkpoint(Phase::Motion);
    for (std::size_t k = begin; k < end; ++k) parts[begin / kBlock].add(motion.placements[k]);
  });
  for (const SweptBox& part : parts) whole.add(part);
  return whole.box();
}

double plannedCell(const Eigen::AlignedBox3d& box, const Options& options) {
  if (options.cellSize) return *options.cellSize;
  return box.sizes().maxCoeff() / (options.resolution - 2 * kGridMarginCells);
}

GridPlan planGrid(const Eigen::AlignedBox3d& box, const Eigen::AlignedBox3d& bodyBox,
                  const Options& options) {
  GridPlan plan;
  plan.cell = plannedCell(box, options);
  if (plan.cell > bodyBox.sizes().maxCoeff()) {
    throw Error(Status::InvalidInput, "CellTooLarge",
                "the cell of " + numberText(plan.cell, 4) + " mm is larger than the whole part (" +
                    numberText(bodyBox.sizes().maxCoeff(), 4) + " mm); use at most " +
                    cellOrAccuracy(bodyBox.sizes().maxCoeff() / 4));
  }
  const double farthest =
      std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  const double precision = farthest * 0x1p-52;
  if (precision > plan.cell / 8) {
    throw Error(Status::InvalidInput, "PrecisionTooCoarse",
                "the part lies up to " + numberText(farthest, 4) +
                    " mm from the origin, where coordinates can only be stored in steps of " +
                    numberText(precision, 4) + " mm. This is too coarse for a cell of " +
                    numberText(plan.cell, 4) +
                    " mm. Move the part closer to the origin, or use a cell above " +
                    numberText(8 * precision, 4) + " mm");
  }
  for (int axis = 0; axis < 3; ++axis) {
    const double cells = std::ceil(box.sizes()[axis] / plan.cell + 2 * kGridMarginCells - 1e-9);
    if (!(cells + 1 <= kMaxPointsPerSide)) {
      throw Error(Status::ResourceLimit, "ResourceLimit",
                  "the grid would have " + numberText(cells, 4) +
                      " cells along one side, but the limit is " +
                      std::to_string(kMaxPointsPerSide - 1) + "; the smallest cell that fits is " +
                      cellOrAccuracy(box.sizes().maxCoeff() / (kMaxPointsPerSide - 4)));
    }
    plan.points[axis] = static_cast<std::int32_t>(cells) + 1;
    const double spare = cells - box.sizes()[axis] / plan.cell;
    plan.origin[axis] = box.min()[axis] - plan.cell * spare / 2;
  }
  return plan;
}

}  // namespace swept
