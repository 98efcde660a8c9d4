// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/dual_surface.h"

#include <algorithm>
#include <memory>

#include "base/parallel.h"
#include "contour/components.h"
#include "contour/qef.h"

namespace swept {
namespace {

/// Vertices keep this far from their cell's walls, so that those of neighbours never coincide.
constexpr double kCellMargin = 1e-4;

/// Gathers the cells of one column (i, j) from the edge lists of the lattice lines round it.
class CellColumn {
 public:
  explicit CellColumn(const HermiteGrid& grid) : grid_(grid), cellAt_(grid.plan.points[2], -1) {}

  std::vector<Cell>& gather(std::int32_t i, std::int32_t j) {
    for (const Cell& cell : cells_) cellAt_[cell.k] = -1;
    cells_.clear();
    for (int di = 0; di < 2; ++di) {
      for (int dj = 0; dj < 2; ++dj) addEdges(2, i + di, j + dj, edgeOf(2, di, dj), -1);
    }
    for (int d = 0; d < 2; ++d) {
      // Edges along x: b = y, c = z. Edges along y: b = z, c = x.
      addEdges(0, i, j + d, edgeOf(0, d, 0), edgeOf(0, d, 1));
      addEdges(1, i + d, j, edgeOf(1, 0, d), edgeOf(1, 1, d));
    }
    return cells_;
  }

 private:
  /// here: the edge's number in the cell at its own k; below: in the cell at k - 1 (-1: none).
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

class LayerBuilder {
 public:
  LayerBuilder(const HermiteGrid& grid, ComponentMethod method, DualSurface& out)
      : grid_(grid),
        out_(out),
        finder_(method),
        column_(grid),
        segments_(method == ComponentMethod::Consistent) {}

  void build(std::int32_t i, std::vector<FaceSegment>& ambiguous) {
    auto& vertices = out_.vertices[i];
    for (std::int32_t j = 0; j + 1 < grid_.plan.points[1]; ++j) {
      for (const Cell& cell : column_.gather(i, j)) {
        addCell(cell, i, j, vertices);
        if (segments_) addSegments(cell, ambiguous);
      }
    }
    vertices.shrink_to_fit();
  }

 private:
  void addCell(const Cell& cell, std::int32_t i, std::int32_t j,
               std::vector<DualVertex>& vertices) {
    const Crossing* crossings = grid_.crossings.data();
    finder_.find(cell, crossings, components_);
    std::array<Qef, kSlots / 2> qefs;
    std::array<float, kSlots / 2> times;
    const auto base = static_cast<std::uint32_t>(vertices.size());
    for (int slot = 0; slot < kSlots; ++slot) {
      const int component = components_.of[slot];
      if (component < 0) continue;
      const std::uint32_t index = cell.crossing(slot);
      const Crossing& crossing = crossings[index];
      const int edge = slot >> 1;
      qefs[component].add(localPosition(edge, crossing.fraction), crossing.normal.cast<double>());
      times[component] = qefs[component].count() == 1
                             ? crossing.timeSeconds
                             : std::min(times[component], crossing.timeSeconds);
      out_.quads[index][quadCorner(edge)] = base + static_cast<std::uint32_t>(component);
    }
    for (int c = 0; c < components_.count; ++c) {
      DualVertex vertex;
      vertex.local = qefs[c].solve(kCellMargin).cast<float>();
      vertex.i = static_cast<std::int16_t>(i);
      vertex.j = static_cast<std::int16_t>(j);
      vertex.k = static_cast<std::int16_t>(cell.k);
      vertex.timeSeconds = times[c];
      vertices.push_back(vertex);
    }
  }

  /// Each face is told once, by the cell that has it on its low side.
  void addSegments(const Cell& cell, std::vector<FaceSegment>& ambiguous) {
    for (int axis = 0; axis < 3; ++axis) {
      const int face = 2 * axis;
      if (faceCrossings(cell.mask, face) <= 2) continue;
      const FacePairs pairs = pairFace(cell, face, grid_.crossings.data());
      for (int p = 0; p < pairs.count; ++p) {
        FaceSegment segment;
        for (int end = 0; end < 2; ++end) {
          const int slot = pairs.slots[p][end];
          segment.crossing[end] = cell.crossing(slot);
          segment.side[end] = static_cast<std::uint8_t>(quadSide(slot >> 1, face));
        }
        segment.firstOfFace = p == 0;
        ambiguous.push_back(segment);
      }
    }
  }

  const HermiteGrid& grid_;
  DualSurface& out_;
  ComponentFinder finder_;
  CellColumn column_;
  Components components_;
  bool segments_;
};

}  // namespace

DualSurface buildDualSurface(const HermiteGrid& grid, ComponentMethod method, RunContext& run) {
  DualSurface out;
  const auto layers = static_cast<std::size_t>(grid.plan.points[0] - 1);
  out.vertices.resize(layers);
  out.quads.assign(grid.crossings.size(), {DualSurface::kNone, DualSurface::kNone,
                                           DualSurface::kNone, DualSurface::kNone});
  std::vector<std::vector<FaceSegment>> ambiguous(layers);
  constexpr std::size_t kGroup = 8;
  parallelBlocks(layers, kGroup, [&](std::size_t begin, std::size_t end) {
    const auto builder = std::make_unique<LayerBuilder>(grid, method, out);
    run.checkpoint(Phase::Contour, begin, 2 * layers);
    for (std::size_t i = begin; i < end; ++i) {
      builder->build(static_cast<std::int32_t>(i), ambiguous[i]);
    }
  });
  out.firstVertex.resize(layers + 1, 0);
  for (std::size_t i = 0; i < layers; ++i) {
    out.firstVertex[i + 1] =
        out.firstVertex[i] + static_cast<std::uint32_t>(out.vertices[i].size());
    out.ambiguous.insert(out.ambiguous.end(), ambiguous[i].begin(), ambiguous[i].end());
  }
  return out;
}

}  // namespace swept
