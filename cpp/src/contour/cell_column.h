// Collects the cells of one column of the grid that have crossings, in the order in which they get
// vertices. Cost: O(crossings of the column).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "contour/cell.h"
#include "grid/hermite_grid.h"

namespace swept {

/// Collects the cells of one column (i, j) from the edge lists of the lattice lines round it.
class CellColumn {
 public:
  explicit CellColumn(const HermiteGrid& grid) : grid_(grid), cellAt_(grid.plan.points[2], -1) {}

  /// Returns the cells of column (i, j) that have crossings. They are valid until the next call.
  std::vector<Cell>& gather(std::int32_t i, std::int32_t j) {
    for (const Cell& cell : cells_) cellAt_[cell.k] = -1;
    cells_.clear();
    for (int di = 0; di < 2; ++di) {
      for (int dj = 0; dj < 2; ++dj) addEdges(2, i + di, j + dj, edgeOf(2, di, dj), -1);
    }
    for (int d = 0; d < 2; ++d) {
      // Edges along x have b = y and c = z; edges along y have b = z and c = x.
      addEdges(0, i, j + d, edgeOf(0, d, 0), edgeOf(0, d, 1));
      addEdges(1, i + d, j, edgeOf(1, 0, d), edgeOf(1, 1, d));
    }
    return cells_;
  }

 private:
  /// Adds the crossed edges (axis, i, j, k), for all k, to the cells of the column. `here` is the
  /// number of such an edge in the cell with the same k. `below` is its number in the cell with
  /// k - 1, or -1 if that cell does not contain the edge.
  void addEdges(int axis, std::int32_t i, std::int32_t j, int here, int below) {
    const HermiteLayer& layer = grid_.layers[i];
    const auto& start = layer.columnStart[axis];
    for (std::uint32_t e = start[j]; e < start[j + 1]; ++e) {
      const HermiteEdge& edge = layer.edges[axis][e];
      put(edge.k, here, edge);
      if (below >= 0) put(edge.k - 1, below, edge);
    }
  }
  void put(std::int32_t k, int number, const HermiteEdge& edge) {
    if (cellAt_[k] < 0) {
      cellAt_[k] = static_cast<std::int32_t>(cells_.size());
      cells_.emplace_back();
      cells_.back().k = static_cast<std::uint16_t>(k);
    }
    Cell& cell = cells_[cellAt_[k]];
    cell.mask |= static_cast<std::uint32_t>(edge.sides) << (2 * number);
    cell.first[number] = edge.first;
  }

  const HermiteGrid& grid_;
  std::vector<std::int32_t> cellAt_;
  std::vector<Cell> cells_;
};

}  // namespace swept
