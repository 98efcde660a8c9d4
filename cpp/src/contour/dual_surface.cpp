// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/dual_surface.h"

#include <algorithm>
#include <bit>
#include <memory>
#include <tuple>
#include <utility>

#include "base/parallel.h"
#include "contour/components.h"
#include "contour/hidden_side.h"
#include "contour/qef.h"
#include "contour/tip_placer.h"
#include "contour/wall_end.h"

namespace swept {
namespace {

/// Cells: a vertex stays in its cell if its planes miss it by less (root mean square). Most creases
/// that seem to lead out of the cell do no more than pass it by beside the mass point; a vertex
/// that follows them for nothing meets others there.
constexpr double kMissed = 0.03;

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

/// Where the planes of a component put its vertex.
struct Placing {
  explicit Placing(const Qef& planes) : qef(planes), best(qef.solve(kCellMargin, free)) {
    out = std::max((-free).maxCoeff(), (free.array() - 1).maxCoeff());
    missed2 = qef.error(best) / qef.count();
  }
  /// The planes meet outside the cell, and miss it.
  bool mayEscape() const {
    return out > kCellMargin && out < 1 - kCellMargin && missed2 > kMissed * kMissed;
  }
  /// The planes do not meet in the cell, by much.
  bool isAmiss() const {
    constexpr double kMuch = 0.1;  // cells
    return missed2 > kMuch * kMuch;
  }
  /// Sharp ones meet outside and miss it by a little.
  bool isDoubtful() const {
    constexpr double kOutside = 0.02, kLittle = 0.008;  // cells
    return out > kOutside && missed2 > kLittle * kLittle && qef.sharpness() > kSharp;
  }

  /// Planes that are one but for a few degrees have nothing to meet in. If they do not lie on one
  /// another, the places of the crossings are wrong by about as much, and where they seem to meet
  /// says nothing: the vertex would fly along the surface, through the other side of a thin wall.
  /// The farther from the mass point, the less it is believed.
  void keepNear() {
    constexpr double kFewDegrees = 0.002;  // sharpness of two planes that differ by 5 degrees
    constexpr double kFar = 0.3;           // cells
    const double damping = missed2 / (kFar * kFar);
    if (damping < 2 * Qef::kDamping || qef.sharpness() > kFewDegrees) return;
    Eigen::Vector3d other;
    best = qef.solve(kCellMargin, damping, other);
  }

  const Qef& qef;
  Eigen::Vector3d free, best;  // minimisers without and with the cell's walls
  double out;                  // cells: how far the free one lies outside
  double missed2;              // mean squared distance of the planes from the best point
};

/// What the cells of a layer leave for later.
struct LayerNotes {
  std::vector<FaceSegment> ambiguous;
  std::vector<Escape> escapes;
  std::vector<RimSegment> rims;
};

class LayerBuilder {
 public:
  LayerBuilder(const HermiteGrid& grid, ComponentMethod method, const SurfaceProbe* probe,
               DualSurface& out)
      : grid_(grid),
        out_(out),
        finder_(method),
        column_(grid),
        segments_(method == ComponentMethod::Consistent),
        probe_(segments_ ? probe : nullptr) {}

  void build(std::int32_t i, LayerNotes& notes) {
    auto& vertices = out_.vertices[i];
    notes_ = &notes;
    for (std::int32_t j = 0; j + 1 < grid_.plan.points[1]; ++j) {
      for (const Cell& cell : column_.gather(i, j)) {
        addCell(cell, i, j, vertices);
        if (segments_) addSegments(cell, notes.ambiguous);
      }
    }
    vertices.shrink_to_fit();
  }

 private:
  void addCell(const Cell& cell, std::int32_t i, std::int32_t j,
               std::vector<DualVertex>& vertices) {
    const Crossing* crossings = grid_.crossings.data();
    finder_.find(cell, crossings, components_);
    auto& qefs = qefs_;
    std::fill_n(qefs.begin(), components_.count, Qef());
    std::array<float, kSlots / 2> times;
    const auto base = static_cast<std::uint32_t>(vertices.size());
    for (std::uint32_t left = cell.mask; left != 0; left &= left - 1) {
      const int slot = std::countr_zero(left), component = components_.of[slot];
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
    const auto firstTwin = static_cast<std::size_t>(base) + components_.count;
    twins_.clear();
    for (int c = 0; c < components_.count; ++c) {
      DualVertex vertex;
      vertex.i = static_cast<std::int16_t>(i);
      vertex.j = static_cast<std::int16_t>(j);
      vertex.k = static_cast<std::int16_t>(cell.k);
      vertex.timeSeconds = times[c];
      Placing placing(qefs[c]);
      if (components_.count > 1) placing.keepNear();
      VertexSplit split;
      const Eigen::Vector3i at(i, j, cell.k);
      if (probe_ != nullptr && (findWallEnd(cell, at, components_, c, crossings, *probe_, split) ||
                                ((placing.isAmiss() || placing.isDoubtful()) &&
                                 findHiddenSide(cell, at, components_, c, crossings, *probe_,
                                                !placing.isAmiss(), split)))) {
        addSplit(cell, c, split, vertex, firstTwin, vertices);
        continue;
      }
      place(placing, vertex, vertices.size());
      vertices.push_back(vertex);
    }
    vertices.insert(vertices.end(), twins_.begin(), twins_.end());
  }

  /// `at`: the number that the vertex is going to have.
  void place(const Placing& placing, DualVertex& vertex, std::size_t at) {
    vertex.local = placing.best.cast<float>();
    if (!placing.mayEscape()) return;
    const Qef& qef = placing.qef;
    notes_->escapes.push_back({static_cast<std::uint32_t>(at), qef.massPoint(), placing.free, qef,
                               qef.error(placing.free) / qef.count()});
  }

  /// One vertex for each part, each with the planes of its part and of the side between them; one
  /// vertex where the component cannot be split.
  void addSplit(const Cell& cell, int component, const VertexSplit& split, DualVertex vertex,
                std::size_t firstTwin, std::vector<DualVertex>& vertices) {
    const bool splits = !split.folds.empty();
    std::array<Qef, 2> sides;
    const Eigen::Vector3d corner(vertex.i, vertex.j, vertex.k);
    for (const ProbeLine& hit : split.between) {
      for (Qef& side : sides) side.add(hit.point - corner, hit.normal);
    }
    const std::size_t twin = firstTwin + twins_.size();
    for (int slot = 0; slot < kSlots; ++slot) {
      if (components_.of[slot] != component) continue;
      const std::uint32_t index = cell.crossing(slot);
      const Crossing& crossing = grid_.crossings[index];
      const int side = split.part[slot];
      if (side < 0) continue;
      sides[side].add(localPosition(slot >> 1, crossing.fraction), crossing.normal.cast<double>());
      if (side == 1) {
        out_.quads[index][quadCorner(slot >> 1)] = static_cast<std::uint32_t>(twin);
      }
    }
    const auto placeOn = [&](const Qef& planes, std::size_t at) {
      Placing placing(planes);
      placing.best = split.alongCrease(planes, placing.best);
      place(placing, vertex, at);
    };
    placeOn(sides[0], vertices.size());
    vertices.push_back(vertex);
    if (!splits) return;
    placeOn(sides[1], twin);
    twins_.push_back(vertex);
    for (std::size_t f = 0; f < split.folds.size(); ++f) {
      RimSegment rim;
      for (int n = 0; n < 2; ++n) {
        const int slot = split.folds[f][n];
        rim.crossing[n] = cell.crossing(slot);
        rim.side[n] = static_cast<std::uint8_t>(quadSide(slot >> 1, split.foldFaces[f]));
        rim.seenFromLow[n] = (slot & 1) == 0;
      }
      if (rim.crossing[0] > rim.crossing[1]) {
        std::swap(rim.crossing[0], rim.crossing[1]);
        std::swap(rim.side[0], rim.side[1]);
        std::swap(rim.seenFromLow[0], rim.seenFromLow[1]);
      }
      notes_->rims.push_back(rim);
    }
  }

  /// Each face is told once, by the cell that has it on its low side.
  void addSegments(const Cell& cell, std::vector<FaceSegment>& ambiguous) {
    for (int axis = 0; axis < 3; ++axis) {
      const int face = 2 * axis;
      if (!hasChoice(cell.mask, face)) continue;
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
  LayerNotes* notes_ = nullptr;
  std::array<Qef, kSlots / 2> qefs_;  // of the cell at hand
  std::vector<DualVertex> twins_;     // of the cell at hand, numbered after its components
  bool segments_;
  const SurfaceProbe* probe_;
};

}  // namespace

DualSurface buildDualSurface(const HermiteGrid& grid, ComponentMethod method,
                             const SurfaceProbe* probe, RunContext& run) {
  DualSurface out;
  const auto layers = static_cast<std::size_t>(grid.plan.points[0] - 1);
  out.vertices.resize(layers);
  out.quads.assign(grid.crossings.size(), {DualSurface::kNone, DualSurface::kNone,
                                           DualSurface::kNone, DualSurface::kNone});
  std::vector<LayerNotes> notes(layers);
  constexpr std::size_t kGroup = 8;
  parallelBlocks(layers, kGroup, [&](std::size_t begin, std::size_t end) {
    const auto builder = std::make_unique<LayerBuilder>(grid, method, probe, out);
    run.checkpoint(Phase::Contour, begin, 2 * layers);
    for (std::size_t i = begin; i < end; ++i) {
      builder->build(static_cast<std::int32_t>(i), notes[i]);
    }
  });
  std::vector<std::vector<Escape>> escapes;
  for (LayerNotes& layer : notes) escapes.push_back(std::move(layer.escapes));
  placeTips(grid, method, escapes, out);
  out.firstVertex.resize(layers + 1, 0);
  for (std::size_t i = 0; i < layers; ++i) {
    out.firstVertex[i + 1] =
        out.firstVertex[i] + static_cast<std::uint32_t>(out.vertices[i].size());
    out.ambiguous.insert(out.ambiguous.end(), notes[i].ambiguous.begin(), notes[i].ambiguous.end());
    out.rims.insert(out.rims.end(), notes[i].rims.begin(), notes[i].rims.end());
  }
  // Both cells of a face may have told it.
  const auto key = [](const RimSegment& rim) { return std::tie(rim.crossing, rim.side); };
  std::sort(out.rims.begin(), out.rims.end(),
            [&](const RimSegment& x, const RimSegment& y) { return key(x) < key(y); });
  out.rims.erase(
      std::unique(out.rims.begin(), out.rims.end(),
                  [&](const RimSegment& x, const RimSegment& y) { return key(x) == key(y); }),
      out.rims.end());
  return out;
}

}  // namespace swept
