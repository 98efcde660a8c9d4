// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/dual_surface.h"

#include <algorithm>
#include <bit>
#include <memory>
#include <tuple>
#include <utility>

#include "base/parallel.h"
#include "contour/cell_column.h"
#include "contour/components.h"
#include "contour/hidden_side.h"
#include "contour/qef.h"
#include "contour/tip_mover.h"
#include "contour/wall_end.h"

namespace swept {
namespace {

/// Limit (cells) of the root mean square distance of a vertex's planes from the best point in the
/// cell. Up to this limit, the vertex stays in its cell, because the planes nearly meet there.
/// Their crease passes through the cell, although the minimiser lies outside. On the fandisk test
/// mesh, moved over 16 keys, at 256 cells, 62 pairs of triangles intersect with this limit, and
/// 1,484 without it.
constexpr double kMinEscapeMiss = 0.03;

/// Fits the vertex of a component to the planes of its crossings.
struct VertexFit {
  explicit VertexFit(const Qef& planes) : qef(planes), best(qef.solve(kCellMargin, free)) {
    out = std::max((-free).maxCoeff(), (free.array() - 1).maxCoeff());
    meanSquaredMiss = qef.error(best) / qef.count();
  }
  /// Returns whether the planes meet outside the cell, less than a cell away, and have no common
  /// point in the cell.
  bool mayEscape() const {
    return out > kCellMargin && out < 1 - kCellMargin &&
           meanSquaredMiss > kMinEscapeMiss * kMinEscapeMiss;
  }
  /// Returns whether the planes clearly have no common point in the cell. The surface then may have
  /// a side in the cell that no grid edge meets (hidden_side.h).
  bool missesCell() const {
    constexpr double kMinMiss = 0.1;  // cells; docs/contouring.md, "Known sides"
    return meanSquaredMiss > kMinMiss * kMinMiss;
  }
  /// Returns whether clearly different planes meet outside the cell and keep at least a small mean
  /// distance from every point in the cell.
  bool mayHideSide() const {
    // In cells. With these limits, 689 of 146,000 cells are probed on the fandisk test mesh
    // (docs/contouring.md).
    constexpr double kMinOutside = 0.02, kMinMiss = 0.008;
    return out > kMinOutside && meanSquaredMiss > kMinMiss * kMinMiss &&
           qef.sharpness() > kMinSharpness;
  }

  /// Moves the minimiser towards the mass point if the planes differ by only a few degrees. Such
  /// planes have no reliable common point: if they are some distance apart, the crossings are
  /// inexact by about this distance. A vertex where they seem to meet could lie far along the
  /// surface and beyond the other side of a thin wall. The damping grows with the mean squared
  /// distance to the planes (docs/contouring.md, "Nearly parallel planes"). In a trial, 25,177
  /// pairs of triangles intersected with damping, and 32,585 without.
  void keepNear() {
    constexpr double kMaxSharpness = 0.002;  // sharpness of two planes that differ by 5 degrees
    // If the planes are this far from the best point (cells), the damping weighs as much as all
    // planes together.
    constexpr double kFullDamping = 0.3;
    const double damping = meanSquaredMiss / (kFullDamping * kFullDamping);
    if (damping < 2 * Qef::kDamping || qef.sharpness() > kMaxSharpness) return;
    Eigen::Vector3d other;
    best = qef.solve(kCellMargin, damping, other);
  }

  const Qef& qef;
  Eigen::Vector3d free, best;  // minimisers without and with the walls of the cell as limits
  double out;              // cells: distance of the free minimiser from the cell, negative inside
  double meanSquaredMiss;  // mean squared distance of the planes from `best`
};

/// Data of one layer of cells that later steps need besides its vertices.
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
  /// Contours a single cell as if it lay at the origin.
  void build(const Cell& cell, LayerNotes& notes) {
    notes_ = &notes;
    addCell(cell, 0, 0, out_.vertices[0]);
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
      VertexFit fit(qefs[c]);
      if (components_.count > 1) fit.keepNear();
      VertexSplit split;
      const Eigen::Vector3i at(i, j, cell.k);
      if (probe_ != nullptr && findSplit(cell, at, c, fit, split)) {
        addSplit(cell, c, split, vertex, firstTwin, vertices);
        continue;
      }
      setPosition(fit, vertex, vertices.size());
      vertices.push_back(vertex);
    }
    vertices.insert(vertices.end(), twins_.begin(), twins_.end());
  }

  /// Looks in the cell for a side of the surface between two other sides (hidden_side.h,
  /// wall_end.h). Returns false if there is none. The component then gets one vertex, fitted to its
  /// own planes.
  bool findSplit(const Cell& cell, const Eigen::Vector3i& at, int component, const VertexFit& fit,
                 VertexSplit& split) const {
    const Crossing* crossings = grid_.crossings.data();
    const bool misses = fit.missesCell();
    if (misses && findKnownSide(cell, at, components_, component, crossings, *probe_, split)) {
      return true;
    }
    return findWallEnd(cell, at, components_, component, crossings, *probe_, split) ||
           ((misses || fit.mayHideSide()) &&
            findHiddenSide(cell, at, components_, component, crossings, *probe_, !misses, split));
  }

  /// Sets the position of a vertex. Records an escape if the planes meet outside the cell. `at`:
  /// index that the vertex will have in its layer.
  void setPosition(const VertexFit& fit, DualVertex& vertex, std::size_t at) {
    vertex.local = fit.best.cast<float>();
    if (!fit.mayEscape()) return;
    const Qef& qef = fit.qef;
    notes_->escapes.push_back({static_cast<std::uint32_t>(at), qef.massPoint(), fit.free, qef,
                               qef.error(fit.free) / qef.count()});
  }

  /// Adds one vertex for each of the two parts, fitted to the planes of the part and of the side
  /// between the parts. Adds a single vertex if the component cannot be split.
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
    const auto setOnCrease = [&](const Qef& planes, std::size_t at) {
      VertexFit fit(planes);
      fit.best = split.alongCrease(planes, fit.best);
      setPosition(fit, vertex, at);
    };
    setOnCrease(sides[0], vertices.size());
    vertices.push_back(vertex);
    if (!splits) return;
    setOnCrease(sides[1], twin);
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

  /// Adds the segments of ambiguous faces. Each face is added once, by the cell on its high side.
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
  std::array<Qef, kSlots / 2> qefs_;  // of the current cell
  std::vector<DualVertex> twins_;     // of the current cell: second vertices of split components
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
  moveTips(grid, method, escapes, out);
  out.firstVertex.resize(layers + 1, 0);
  for (std::size_t i = 0; i < layers; ++i) {
    out.firstVertex[i + 1] =
        out.firstVertex[i] + static_cast<std::uint32_t>(out.vertices[i].size());
    out.ambiguous.insert(out.ambiguous.end(), notes[i].ambiguous.begin(), notes[i].ambiguous.end());
    out.rims.insert(out.rims.end(), notes[i].rims.begin(), notes[i].rims.end());
  }
  // Both cells of a face may have added the same rim polygon, so duplicates are removed.
  const auto key = [](const RimSegment& rim) { return std::tie(rim.crossing, rim.side); };
  std::sort(out.rims.begin(), out.rims.end(),
            [&](const RimSegment& x, const RimSegment& y) { return key(x) < key(y); });
  out.rims.erase(
      std::unique(out.rims.begin(), out.rims.end(),
                  [&](const RimSegment& x, const RimSegment& y) { return key(x) == key(y); }),
      out.rims.end());
  return out;
}

void probeCell(const Cell& cell, const std::vector<Crossing>& crossings, ComponentMethod method,
               const SurfaceProbe& probe) {
  HermiteGrid grid;
  grid.crossings = crossings;
  DualSurface dropped;
  dropped.vertices.resize(1);
  dropped.quads.resize(crossings.size());
  LayerNotes notes;
  std::make_unique<LayerBuilder>(grid, method, &probe, dropped)->build(cell, notes);
}

}  // namespace swept
