// Finds which vertices of a surface belong to which cell.
//
// In: a surface as contoured (component vertices first, in the order of the cells), and its grid.
// Cost: O(crossings) for the constructor; O(crossings of a column) for each query. 4 bytes per cell
// with crossings, 4 bytes per column of the grid.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "contour/cell_column.h"
#include "contour/surface.h"

namespace swept {

class CellVertices {
 public:
  CellVertices(const HermiteGrid& grid, const Surface& surface);

  /// The vertices of a cell are [first, end); the range is empty for a cell without crossings.
  struct Range {
    std::int32_t first = 0, end = 0;
    bool contains(std::int32_t v) const { return v >= first && v < end; }
  };
  Range of(const Eigen::Vector3i& cell);
  /// Returns the cell of a component's vertex.
  Eigen::Vector3i cellOf(std::int32_t vertex);
  /// Returns the crossings of a cell.
  Cell crossingsOf(const Eigen::Vector3i& cell);

 private:
  std::size_t columnOf(const Eigen::Vector3i& cell) const {
    return static_cast<std::size_t>(cell[0]) * columns_ + cell[1];
  }
  /// Returns the number of a cell within its column, or -1 for a cell without crossings.
  std::int32_t numberInColumn(const Eigen::Vector3i& cell);

  CellColumn column_;
  std::size_t columns_;                   // number of columns in a layer of cells
  std::vector<std::uint32_t> firstCell_;  // per column, with one more entry at the end
  /// Per cell with crossings: its first vertex; with one more entry at the end.
  std::vector<std::int32_t> firstVertex_;
};

}  // namespace swept
