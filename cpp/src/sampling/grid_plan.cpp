// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sampling/grid_plan.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace swept {
namespace {

constexpr double kMarginCells =
    1.37;  ///< empty cells to each side; odd, so that planes of the body miss it

std::string number(double value) {
  std::ostringstream text;
  text.precision(4);
  text << value;
  return text.str();
}

}  // namespace

Eigen::AlignedBox3d sweptBox(const TriMesh& body, const Motion& motion) {
  Eigen::AlignedBox3d bodyBox;
  for (const auto& v : body.vertices) bodyBox.extend(v);
  const Eigen::Vector3d centre = bodyBox.center(), half = bodyBox.sizes() / 2;
  Eigen::AlignedBox3d box;
  // Placements in order of their own centre's extremes would prune more; a stride order is enough.
  const std::size_t n = motion.placements.size();
  const std::size_t stride = n > 64 ? n / 64 : 1;
  const auto add = [&](const Placement& p) {
    const Eigen::Vector3d c = p.apply(centre), reach = p.rotation.cwiseAbs() * half;
    if (!box.isEmpty() && ((c - reach).array() >= box.min().array()).all() &&
        ((c + reach).array() <= box.max().array()).all()) {
      return;
    }
    Eigen::Vector3d low = c, high = c;
    for (const auto& v : body.vertices) {
      const Eigen::Vector3d x = p.apply(v);
      low = low.cwiseMin(x);
      high = high.cwiseMax(x);
    }
    box.extend(low);
    box.extend(high);
  };
  for (std::size_t i = 0; i < n; i += stride) add(motion.placements[i]);
  add(motion.placements.back());
  if (stride > 1) {
    for (std::size_t i = 0; i < n; ++i) add(motion.placements[i]);
  }
  return box;
}

double plannedCell(const Eigen::AlignedBox3d& box, const Options& options) {
  if (options.cellSize > 0) return options.cellSize;
  return box.sizes().maxCoeff() / (options.resolution - 2 * kMarginCells);
}

GridPlan planGrid(const Eigen::AlignedBox3d& box, const Eigen::AlignedBox3d& bodyBox,
                  const Options& options) {
  GridPlan plan;
  plan.cell = plannedCell(box, options);
  if (plan.cell > bodyBox.sizes().maxCoeff()) {
    throw Error(Status::InvalidInput, "CellTooLarge",
                "the cell of " + number(plan.cell) + " mm is larger than the whole body (" +
                    number(bodyBox.sizes().maxCoeff()) + " mm); use at most " +
                    number(bodyBox.sizes().maxCoeff() / 4) + " mm");
  }
  const double farthest =
      std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  const double precision = farthest * 0x1p-52;
  if (precision > plan.cell / 8) {
    throw Error(Status::InvalidInput, "PrecisionTooCoarse",
                "the body stands up to " + number(farthest) +
                    " mm from the origin, where numbers "
                    "are " +
                    number(precision) + " mm apart; the cell is " + number(plan.cell) +
                    " mm: move the body closer to the origin or use a cell above " +
                    number(8 * precision) + " mm");
  }
  for (int axis = 0; axis < 3; ++axis) {
    const double cells = std::ceil(box.sizes()[axis] / plan.cell + 2 * kMarginCells - 1e-9);
    if (!(cells + 1 <= kMaxPointsPerSide)) {
      throw Error(Status::ResourceLimit, "ResourceLimit",
                  "the grid would have " + number(cells) + " cells along one side, the limit is " +
                      std::to_string(kMaxPointsPerSide - 1) + "; the smallest cell that fits is " +
                      number(box.sizes().maxCoeff() / (kMaxPointsPerSide - 4)) + " mm");
    }
    plan.points[axis] = static_cast<std::int32_t>(cells) + 1;
    const double spare = cells - box.sizes()[axis] / plan.cell;
    plan.origin[axis] = box.min()[axis] - plan.cell * spare / 2;
  }
  return plan;
}

}  // namespace swept
