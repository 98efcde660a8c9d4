// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/dual_surface.h"

#include <algorithm>
#include <bit>
#include <memory>
#include <tuple>
#include <unordered_set>

#include "base/parallel.h"
#include "contour/components.h"
#include "contour/hidden_side.h"
#include "contour/qef.h"
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

/// A vertex whose planes meet outside its cell.
struct Escape {
  std::uint32_t vertex;      // in its layer
  Eigen::Vector3d from, to;  // mass point and minimiser, in the cell's coordinates
  Qef planes;                // in the cell's coordinates
  double error;              // mean squared distance of the planes from the minimiser
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
    constexpr double kSharp = 0.03;                     // two planes that differ by 20 degrees
    return out > kOutside && missed2 > kLittle * kLittle && qef.sharpness() > kSharp;
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
      const Placing placing(qefs[c]);
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
  LayerNotes* notes_ = nullptr;
  std::array<Qef, kSlots / 2> qefs_;  // of the cell at hand
  std::vector<DualVertex> twins_;     // of the cell at hand, numbered after its components
  bool segments_;
  const SurfaceProbe* probe_;
};

/// Any single cell of the grid, found by binary search in the edge lists.
Cell gatherCell(const HermiteGrid& grid, const Eigen::Vector3i& at) {
  Cell cell;
  for (int axis = 0; axis < 3; ++axis) {
    if (at[axis] < 0 || at[axis] + 1 >= grid.plan.points[axis]) return cell;
  }
  cell.k = static_cast<std::uint16_t>(at[2]);
  for (int axis = 0; axis < 3; ++axis) {
    for (int ob = 0; ob < 2; ++ob) {
      for (int oc = 0; oc < 2; ++oc) {
        Eigen::Vector3i low = at;
        low[(axis + 1) % 3] += ob;
        low[(axis + 2) % 3] += oc;
        const HermiteLayer& layer = grid.layers[low[0]];
        const auto begin = layer.edges[axis].begin() + layer.columnStart[axis][low[1]];
        const auto end = layer.edges[axis].begin() + layer.columnStart[axis][low[1] + 1];
        const auto edge = std::lower_bound(begin, end, low[2],
                                           [](const HermiteEdge& e, int k) { return e.k < k; });
        if (edge == end || edge->k != low[2]) continue;
        const int number = edgeOf(axis, ob, oc);
        cell.mask |= static_cast<std::uint32_t>(edge->sides) << (2 * number);
        cell.first[number] = edge->first;
      }
    }
  }
  return cell;
}

/// Vertices whose planes meet outside their cell: what becomes of the point where they meet.
///   Its way leads through empty cells: the vertex may follow (the tip of a corner or wedge can
///   reach into a neighbour without meeting any of its edges; nothing else lives there). It lies in
///   a neighbouring leaf cell: a component there whose own planes agree with it takes it (it saw
///   only some of the planes of the corner that it holds).
/// A cell is given one point only; whatever still meets is found and mended later.
class TipPlacer {
 public:
  TipPlacer(const HermiteGrid& grid, ComponentMethod method, DualSurface& surface)
      : grid_(grid), method_(method), surface_(surface) {}

  void place(const std::vector<LayerNotes>& notes) {
    std::vector<std::vector<Claim>> byLayer(notes.size());
    parallelFor(notes.size(), [&](std::size_t layer) {
      const auto finder = std::make_unique<ComponentFinder>(method_);
      for (const Escape& escape : notes[layer].escapes) {
        claim(static_cast<std::uint32_t>(layer), escape, *finder, byLayer[layer]);
      }
    });
    std::vector<Claim> claims;
    for (const auto& part : byLayer) claims.insert(claims.end(), part.begin(), part.end());
    std::stable_sort(claims.begin(), claims.end(), [](const Claim& x, const Claim& y) {
      for (int axis = 0; axis < 3; ++axis) {
        if (x.cell[axis] != y.cell[axis]) return x.cell[axis] < y.cell[axis];
      }
      if (x.corner != y.corner) return x.corner;
      return x.error < y.error;
    });
    // A vertex with a point of its own outside its cell goes there, whatever others ask it to take.
    std::unordered_set<std::uint64_t> moved;
    for (const bool own : {true, false}) {
      std::size_t group = 0;  // first claim on the same cell
      for (std::size_t n = 0; n < claims.size(); ++n) {
        if (claims[n].cell != claims[group].cell) group = n;
        if (claims[n].own == own) grant(claims, group, n, moved);
      }
    }
  }

 private:
  struct Claim {
    Eigen::Vector3i cell;
    double error;
    std::uint32_t layer, vertex;
    Eigen::Vector3d point;  // grid coordinates
    bool own;     // the vertex's own planes meet there; else it takes a point for another one
    bool corner;  // three planes meet there: goes before creases
    bool granted = false;
  };
  void grant(std::vector<Claim>& claims, std::size_t group, std::size_t n,
             std::unordered_set<std::uint64_t>& moved) {
    Claim& claim = claims[n];
    const auto key = static_cast<std::uint64_t>(claim.layer) << 32 | claim.vertex;
    if (moved.contains(key)) return;
    for (std::size_t m = group; m < claims.size() && claims[m].cell == claim.cell; ++m) {
      if (claims[m].granted && (claims[m].point - claim.point).norm() <= kApart) return;
    }
    claim.granted = true;
    moved.insert(key);
    DualVertex& v = surface_.vertices[claim.layer][claim.vertex];
    v.local = (claim.point - Eigen::Vector3d(v.i, v.j, v.k)).cast<float>();
  }

  static constexpr double kApart = 0.1;  // cells between two vertices on one crease

  void claim(std::uint32_t layer, const Escape& escape, ComponentFinder& finder,
             std::vector<Claim>& out) {
    if (escape.error > kPlanesMeet || escape.planes.sharpness() < kSharp) return;
    const DualVertex& v = surface_.vertices[layer][escape.vertex];
    const Eigen::Vector3i own(v.i, v.j, v.k);
    const Eigen::Vector3d way = escape.to - escape.from;
    const Eigen::Vector3i target = own + escape.to.array().floor().matrix().cast<int>();
    const Eigen::Vector3d point = escape.to + own.cast<double>();
    const double count = escape.planes.count();
    const bool corner = escape.planes.matrix().determinant() > kCorner * count * count * count;
    const Cell cell = gatherCell(grid_, target);
    if (cell.mask != 0) {
      const auto [vertex, wholly] = agreeing(cell, target, point, finder);
      if (vertex == DualSurface::kNone) return;
      const DualVertex& taker = surface_.vertices[target[0]][vertex];
      const Eigen::Vector3d there =
          Eigen::Vector3d(taker.i, taker.j, taker.k) + taker.local.cast<double>();
      const double missed = escape.planes.error(there - own.cast<double>()) / escape.planes.count();
      if (missed > kPlanesMeet) {
        if (!wholly) return;
        out.push_back({target, way.norm(), static_cast<std::uint32_t>(target[0]), vertex, point,
                       false, corner});
      } else if ((there - point).norm() > kApart) {
        // The neighbour stands on the same crease: this vertex may go there as well.
        out.push_back({target, way.norm(), layer, escape.vertex, point, true, corner});
      }
      return;
    }
    constexpr int kSamples = 16;  // corners cut shorter than this do no harm
    for (int s = 1; s < kSamples; ++s) {
      const Eigen::Vector3d x = escape.from + way * (static_cast<double>(s) / kSamples);
      const Eigen::Vector3i step = x.array().floor().matrix().cast<int>();
      if (step == Eigen::Vector3i::Zero()) continue;
      const Cell passed = gatherCell(grid_, own + step);
      if (passed.mask != 0 &&
          agreeing(passed, own + step, point, finder).vertex == DualSurface::kNone) {
        return;
      }
    }
    out.push_back({target, way.norm(), layer, escape.vertex, point, true, corner});
  }

  /// Vertex of the first component of a leaf cell on whose crease the point lies, or kNone: its
  /// planes pass through the point, or two or more do that make a crease and the point is behind
  /// the others (the crease ends at them, in a corner that the cell holds).
  struct Agreement {
    std::uint32_t vertex = DualSurface::kNone;
    bool wholly = false;  // all planes of the component pass through the point
  };
  Agreement agreeing(const Cell& cell, const Eigen::Vector3i& at, const Eigen::Vector3d& point,
                     ComponentFinder& finder) const {
    Components components;
    finder.find(cell, grid_.crossings.data(), components);
    const Eigen::Vector3d local = point - at.cast<double>();
    for (int c = 0; c < components.count; ++c) {
      Qef all, through;
      bool behind = true;
      std::uint32_t vertex = DualSurface::kNone;
      for (int slot = 0; slot < kSlots; ++slot) {
        if (components.of[slot] != c) continue;
        const Crossing& crossing = grid_.crossings[cell.crossing(slot)];
        const Eigen::Vector3d position = localPosition(slot >> 1, crossing.fraction);
        const Eigen::Vector3d normal = crossing.normal.cast<double>();
        const double distance = normal.dot(local - position);
        all.add(position, normal);
        if (distance * distance <= kPlanesMeet) {
          through.add(position, normal);
        } else {
          behind &= distance < 0;
        }
        vertex = surface_.quads[cell.crossing(slot)][quadCorner(slot >> 1)];
      }
      if (all.error(local) <= kPlanesMeet * all.count()) return {vertex, true};
      if (behind && through.count() > 1 && through.sharpness() >= kSharp) return {vertex, false};
    }
    return {};
  }

  static constexpr double kSharp = 0.05;       // two planes that differ by 26 degrees
  static constexpr double kCorner = 1e-3;      // of the planes' product; 0.037 for a cube's corner
  static constexpr double kPlanesMeet = 1e-4;  // mean squared distance of the planes, cells: 0.01

  const HermiteGrid& grid_;
  ComponentMethod method_;
  DualSurface& surface_;
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
  TipPlacer(grid, method, out).place(notes);
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
