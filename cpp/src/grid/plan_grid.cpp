// SPDX-License-Identifier: LGPL-2.1-or-later
#include "grid/plan_grid.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/accuracy_text.h"
#include "base/number_text.h"
#include "base/parallel.h"

namespace swept {
namespace {

/// Returns the vertices that can be the farthest along a world axis at any placement. In
/// coordinates of the body, the axis has a unit direction at each placement. These directions
/// differ from the first one, d, by vectors of length `turn` or less. So the distance of one vertex
/// ahead of another along the axis changes by at most 2 * radius * turn. A vertex that lies farther
/// behind than this at the first placement can never become the farthest.
std::vector<std::int32_t> foremost(const TriMesh& body, const Eigen::Vector3d& centre,
                                   const Motion& motion, int axis, double side) {
  const Eigen::RowVector3d d = side * motion.placements.front().rotation.row(axis);
  double turn = 0, radius = 0, farthest = -HUGE_VAL;
  for (const Placement& p : motion.placements) {
    turn = std::max(turn, (side * p.rotation.row(axis) - d).norm());
  }
  for (const auto& v : body.vertices) {
    radius = std::max(radius, (v - centre).norm());
    farthest = std::max(farthest, d.dot(v - centre));
  }
  std::vector<std::int32_t> out;
  for (std::size_t v = 0; v < body.vertices.size(); ++v) {
    if (d.dot(body.vertices[v] - centre) >= farthest - 2 * radius * turn - 1e-9 * radius) {
      out.push_back(static_cast<std::int32_t>(v));
    }
  }
  return out;
}

/// Returns the bounding box of the body in many similar placements. Returns an empty box if the
/// placements differ so much that, along one of the axes, foremost() returns more than 1/16 of the
/// vertices.
Eigen::AlignedBox3d boxOfSimilarPlacements(const TriMesh& body, const Eigen::Vector3d& centre,
                                           const Motion& motion) {
  Eigen::AlignedBox3d box;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      const std::vector<std::int32_t> front = foremost(body, centre, motion, axis, side);
      if (front.size() > body.vertices.size() / 16) return {};
      constexpr std::size_t kBlock = 4096;
      const std::size_t n = motion.placements.size();
      std::vector<double> parts(n / kBlock + 1, -HUGE_VAL);
      parallelBlocks(n, kBlock, [&](std::size_t begin, std::size_t end) {
        double& farthest = parts[begin / kBlock];
        for (std::size_t k = begin; k < end; ++k) {
          for (const std::int32_t v : front) {
            farthest =
                std::max(farthest, side * motion.placements[k].apply(body.vertices[v])[axis]);
          }
        }
      });
      const double farthest = side * *std::max_element(parts.begin(), parts.end());
      (side < 0 ? box.min() : box.max())[axis] = farthest;
    }
  }
  return box;
}

}  // namespace

Eigen::AlignedBox3d sweptBox(const TriMesh& body, const Motion& motion, RunContext& run) {
  Eigen::AlignedBox3d bodyBox;
  for (const auto& v : body.vertices) bodyBox.extend(v);
  const Eigen::Vector3d centre = bodyBox.center(), half = bodyBox.sizes() / 2;
  Eigen::AlignedBox3d box;
  // A placement is skipped if the box of the body there lies in the box found so far. Visiting the
  // placements in strides finds a large box early.
  const std::size_t n = motion.placements.size();
  // With at least this many placements, the search for the foremost vertices saves time.
  constexpr std::size_t kMany = 1024;
  if (n >= kMany) {
    box = boxOfSimilarPlacements(body, centre, motion);
    if (!box.isEmpty()) return box;
  }
  const std::size_t stride = n > 64 ? n / 64 : 1;
  const auto add = [&](const Placement& p) {
    const Eigen::Vector3d c = p.apply(centre), reach = p.rotation.cwiseAbs() * half;
    if (!box.isEmpty() && ((c - reach).array() >= box.min().array()).all() &&
        ((c + reach).array() <= box.max().array()).all()) {
      return;
    }
    run.checkpoint(Phase::Motion);
    constexpr std::size_t kBlock = 4096;
    std::vector<Eigen::AlignedBox3d> parts(body.vertices.size() / kBlock + 1);
    parallelBlocks(body.vertices.size(), kBlock, [&](std::size_t begin, std::size_t end) {
      Eigen::Vector3d low = c, high = c;
      for (std::size_t v = begin; v < end; ++v) {
        const Eigen::Vector3d x = p.apply(body.vertices[v]);
        low = low.cwiseMin(x);
        high = high.cwiseMax(x);
      }
      parts[begin / kBlock] = {low, high};
    });
    for (const Eigen::AlignedBox3d& part : parts) box.extend(part);
  };
  for (std::size_t i = 0; i < n; i += stride) add(motion.placements[i]);
  add(motion.placements.back());
  if (stride > 1) {
    for (std::size_t i = 0; i < n; ++i) add(motion.placements[i]);
  }
  return box;
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
