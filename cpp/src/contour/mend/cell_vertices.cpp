// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/mend/cell_vertices.h"

#include <algorithm>
#include <numeric>

#include "base/parallel.h"

namespace swept {

CellVertices::CellVertices(const HermiteGrid& grid, const Surface& surface)
    : column_(grid), columns_(static_cast<std::size_t>(grid.plan.points[1] - 1)) {
  const auto layers = static_cast<std::size_t>(grid.plan.points[0] - 1);
  firstCell_.assign(layers * columns_ + 1, 0);
  parallelBlocks(layers, 8, [&](std::size_t begin, std::size_t end) {
    CellColumn column(grid);
    for (std::size_t i = begin; i < end; ++i) {
      for (std::size_t j = 0; j < columns_; ++j) {
        firstCell_[i * columns_ + j + 1] = static_cast<std::uint32_t>(
            column.gather(static_cast<std::int32_t>(i), static_cast<std::int32_t>(j)).size());
      }
    }
  });
  std::partial_sum(firstCell_.begin(), firstCell_.end(), firstCell_.begin());
  firstVertex_.reserve(firstCell_.back() + std::size_t{1});
  for (std::size_t v = 0; v < surface.cellFlags.size(); ++v) {
    if ((surface.cellFlags[v] & Surface::kSharedWithPrevious) == 0)
      firstVertex_.push_back(static_cast<std::int32_t>(v));
  }
  firstVertex_.push_back(static_cast<std::int32_t>(surface.cellFlags.size()));
}

std::int32_t CellVertices::numberInColumn(const Eigen::Vector3i& cell) {
  const std::vector<Cell>& cells = column_.gather(cell[0], cell[1]);
  const auto found = std::find_if(cells.begin(), cells.end(),
                                  [&](const Cell& c) { return static_cast<int>(c.k) == cell[2]; });
  return found == cells.end() ? -1 : static_cast<std::int32_t>(found - cells.begin());
}

CellVertices::Range CellVertices::of(const Eigen::Vector3i& cell) {
  const std::int32_t number = numberInColumn(cell);
  if (number < 0) return {};
  const std::size_t at = firstCell_[columnOf(cell)] + static_cast<std::size_t>(number);
  return {firstVertex_[at], firstVertex_[at + 1]};
}

Eigen::Vector3i CellVertices::cellOf(std::int32_t vertex) {
  const auto cell = static_cast<std::uint32_t>(
      std::upper_bound(firstVertex_.begin(), firstVertex_.end(), vertex) - firstVertex_.begin() -
      1);
  const auto column = static_cast<std::size_t>(
      std::upper_bound(firstCell_.begin(), firstCell_.end(), cell) - firstCell_.begin() - 1);
  const auto i = static_cast<std::int32_t>(column / columns_),
             j = static_cast<std::int32_t>(column % columns_);
  return {i, j, static_cast<int>(column_.gather(i, j)[cell - firstCell_[column]].k)};
}

Cell CellVertices::crossingsOf(const Eigen::Vector3i& cell) {
  const std::int32_t number = numberInColumn(cell);
  return number < 0 ? Cell{} : column_.gather(cell[0], cell[1])[number];
}

}  // namespace swept
