// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/mend/rebuild.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "base/parallel.h"
#include "check/near_pairs.h"
#include "contour/mend/cell_patch.h"
#include "contour/mend/cell_vertices.h"
#include "contour/mend/keep_triangles.h"
#include "contour/mend/region.h"

namespace swept {
namespace {

using Triangle = std::array<std::int32_t, 3>;
using CellIndex = std::array<int, 3>;

/// Largest number of rounds, to limit the time. Each round adds the cells of the triangles that
/// still intersect.
constexpr int kRebuildRounds = 24;
/// A vertex nearer to a wall of its cell than this (cells) gets another position.
constexpr double kInside = 1e-3;

Eigen::Vector3i vectorOf(const CellIndex& cell) { return {cell[0], cell[1], cell[2]}; }

/// Returns the cell at a corner of the quad round a lattice edge (quadCorner() in cell.h).
CellIndex cellAtCorner(const CrossingEdge& edge, int corner) {
  CellIndex cell{edge.i, edge.j, edge.k};
  if (corner == 0 || corner == 3) --cell[(edge.axis + 1) % 3];
  if (corner == 0 || corner == 1) --cell[(edge.axis + 2) % 3];
  return cell;
}

CellIndex behindFace(CellIndex cell, int face) {
  cell[face >> 1] += (face & 1) != 0 ? 1 : -1;
  return cell;
}

/// The polygon of a crossing before rebuilding: its border, and the vertices of its four cells.
struct OldPolygon {
  std::vector<std::int32_t> border;
  std::array<std::int32_t, 4> vertex{-1, -1, -1, -1};  ///< by corner of the quad
};

class Rebuilder {
 public:
  Rebuilder(Surface& surface, const HermiteGrid& grid, RunContext& run)
      : surface_(surface),
        mesh_(surface.mesh),
        grid_(grid),
        run_(run),
        cellVertices_(grid, surface),
        vertexCount_(mesh_.vertices.size()),
        triangleCount_(mesh_.triangles.size()) {}

  /// Adds the cells of the intersecting triangles. Returns false if all of them were added before.
  bool addCells(const SelfIntersections& pairs) {
    const std::size_t before = cells_.size();
    for (const auto& [a, b] : pairs.pairs) {
      for (const std::int32_t t : {a, b}) addCellsOf(t);
    }
    return cells_.size() > before;
  }

  /// Rebuilds the cells from the original surface, and returns the pairs of triangles that
  /// intersect now.
  SelfIntersections rebuild() {
    reset();
    collectCells();
    removeTriangles();
    addFixedPoints();
    for (const std::uint32_t crossing : crossings_) addPolygon(crossing);
    for (const auto& [index, cell] : rebuilt_) addCell(index, cell);
    return findPairs();
  }

  /// Restores the original surface.
  void reset() {
    mesh_.vertices.resize(vertexCount_);
    surface_.contactTime.resize(vertexCount_);
    mesh_.triangles.resize(triangleCount_);
    surface_.crossingOf.resize(triangleCount_);
    removed_.clear();
  }

  void dropRemoved(SelfIntersections& pairs) {
    std::vector<std::uint8_t> keeps(mesh_.triangles.size(), 1);
    for (const std::int32_t t : removed_) keeps[t] = 0;
    for (std::size_t v = vertexCount_; v < mesh_.vertices.size(); ++v)
      surface_.mended.push_back(static_cast<std::int32_t>(v));
    keepTriangles(surface_, keeps, pairs);
  }

 private:
  struct RebuiltCell {
    Cell crossings;
    std::vector<CellRing> rings;
    CellVertices::Range vertices;
  };

  void addCellsOf(std::int32_t t) {
    const std::uint32_t crossing = surface_.crossingOf[t];
    if (crossing != Surface::kNoCrossing) {
      const CrossingEdge edge = edgeOfCrossing(grid_, crossing);
      for (int corner = 0; corner < 4; ++corner) cells_.insert(cellAtCorner(edge, corner));
      return;
    }
    for (const std::int32_t v : mesh_.triangles[t]) {
      if (static_cast<std::size_t>(v) >= surface_.cellFlags.size()) continue;
      const Eigen::Vector3i cell = cellVertices_.cellOf(v);
      cells_.insert({cell[0], cell[1], cell[2]});
    }
  }

  void collectCells() {
    for (const CellIndex& index : cells_) {
      if (rebuilt_.contains(index)) continue;
      RebuiltCell cell{
          cellVertices_.crossingsOf(vectorOf(index)), {}, cellVertices_.of(vectorOf(index))};
      cell.rings = ringsOf(cell.crossings, grid_.crossings.data());
      for (int slot = 0; slot < kSlots; ++slot) {
        if (cell.crossings.has(slot)) crossings_.insert(cell.crossings.crossing(slot));
      }
      rebuilt_.emplace(index, std::move(cell));
    }
  }

  /// Removes the polygons of all crossings of the rebuilt cells. Also removes the triangles at the
  /// vertices of these cells that close the ends of thin walls.
  void removeTriangles() {
    std::vector<std::uint8_t> ofCrossing(grid_.crossings.size()), ofVertex(mesh_.vertices.size());
    for (const std::uint32_t crossing : crossings_) ofCrossing[crossing] = 1;
    for (const auto& [index, cell] : rebuilt_) {
      std::fill(ofVertex.begin() + cell.vertices.first, ofVertex.begin() + cell.vertices.end, 1);
    }
    removed_ = gather<std::int32_t>(
        triangleCount_, kTrianglesPerTask, [&](std::size_t t, std::vector<std::int32_t>& part) {
          const std::uint32_t crossing = surface_.crossingOf[t];
          const Triangle& corners = mesh_.triangles[t];
          const bool removes = crossing != Surface::kNoCrossing
                                   ? ofCrossing[crossing] != 0
                                   : std::any_of(corners.begin(), corners.end(),
                                                 [&](std::int32_t v) { return ofVertex[v] != 0; });
          if (removes) part.push_back(static_cast<std::int32_t>(t));
        });
    polygons_.clear();
    std::map<std::uint32_t, std::vector<std::int32_t>> triangles;
    for (const std::int32_t t : removed_) {
      if (surface_.crossingOf[t] != Surface::kNoCrossing)
        triangles[surface_.crossingOf[t]].push_back(t);
    }
    for (const auto& [crossing, members] : triangles)
      polygons_.emplace(crossing, polygonOf(crossing, members));
  }

  OldPolygon polygonOf(std::uint32_t crossing, const std::vector<std::int32_t>& triangles) {
    std::map<std::int32_t, std::int32_t> after;  // the next vertex along the border
    std::set<std::pair<std::int32_t, std::int32_t>> sides;
    for (const std::int32_t t : triangles) {
      for (int c = 0; c < 3; ++c)
        sides.emplace(mesh_.triangles[t][c], mesh_.triangles[t][(c + 1) % 3]);
    }
    for (const auto& [from, to] : sides) {
      if (!sides.contains({to, from})) after[from] = to;
    }
    OldPolygon polygon;
    for (std::int32_t v = after.begin()->first; polygon.border.size() < after.size(); v = after[v])
      polygon.border.push_back(v);
    const CrossingEdge edge = edgeOfCrossing(grid_, crossing);
    for (int corner = 0; corner < 4; ++corner) {
      const CellVertices::Range range = verticesOf(cellAtCorner(edge, corner));
      for (const std::int32_t v : polygon.border) {
        if (range.contains(v)) polygon.vertex[corner] = v;
      }
    }
    return polygon;
  }

  CellVertices::Range verticesOf(const CellIndex& cell) {
    const auto [found, isNew] = ranges_.try_emplace(cell);
    if (isNew) found->second = cellVertices_.of(vectorOf(cell));
    return found->second;
  }

  /// Adds the points that neighbouring cells share: crossings, and points of the chords on the
  /// walls between the cells.
  void addFixedPoints() {
    crossingAt_.clear();
    chordAt_.clear();
    const Crossing* crossings = grid_.crossings.data();
    for (const auto& [index, cell] : rebuilt_) {
      for (const CellRing& ring : cell.rings) {
        for (std::size_t n = 0; n < ring.slots.size(); ++n) {
          const int slot = ring.slots[n], next = ring.slots[(n + 1) % ring.slots.size()];
          const int face = ring.faces[n];
          const std::uint32_t x = cell.crossings.crossing(slot), y = cell.crossings.crossing(next);
          if (!crossingAt_.contains(x))
            crossingAt_[x] = addVertex(index, apartPosition(cell.crossings, slot, crossings), x);
          const auto [found, isNew] = chordAt_.try_emplace({x, quadSide(slot >> 1, face)}, 0);
          if (!isNew) continue;
          found->second =
              addVertex(index, chordPoint(cell.crossings, face, slot, next, crossings), x);
          chordAt_[{y, quadSide(next >> 1, face)}] = found->second;
        }
      }
    }
  }

  std::int32_t addVertex(const CellIndex& cell, const Eigen::Vector3d& local,
                         std::uint32_t crossing) {
    return addVertex(cellBoxOf(cell).toWorld(local), grid_.crossings[crossing].timeSeconds);
  }
  std::int32_t addVertex(const Eigen::Vector3d& world, double time) {
    mesh_.vertices.push_back(world);
    surface_.contactTime.push_back(time);
    return static_cast<std::int32_t>(mesh_.vertices.size()) - 1;
  }
  void addTriangle(const Triangle& triangle, std::uint32_t crossing) {
    mesh_.triangles.push_back(triangle);
    surface_.crossingOf.push_back(crossing);
  }
  CellBox cellBoxOf(const CellIndex& cell) const {
    return {grid_.plan.origin + grid_.plan.cell * vectorOf(cell).cast<double>(), grid_.plan.cell};
  }

  /// Adds the part of a crossing's polygon that lies in cells that are not rebuilt: a fan about the
  /// crossing.
  void addPolygon(std::uint32_t crossing) {
    const OldPolygon& polygon = polygons_.at(crossing);
    const CrossingEdge edge = edgeOfCrossing(grid_, crossing);
    const auto isRebuilt = [&](int corner) { return cells_.contains(cellAtCorner(edge, corner)); };
    const auto cornerOf = [&](std::int32_t v) {
      const auto at = std::find(polygon.vertex.begin(), polygon.vertex.end(), v);
      return at == polygon.vertex.end() ? -1 : static_cast<int>(at - polygon.vertex.begin());
    };
    const std::int32_t centre = crossingAt_.at(crossing);
    const std::vector<std::int32_t>& border = polygon.border;
    const std::size_t n = border.size();
    for (std::size_t at = 0; at < n; ++at) {
      const int from = cornerOf(border[at]);
      if (from < 0) continue;
      std::size_t length = 1;
      while (cornerOf(border[(at + length) % n]) < 0) ++length;
      const int to = cornerOf(border[(at + length) % n]);
      const int side = to == ((from + 1) & 3) ? from : to;
      if (!isRebuilt(from) && !isRebuilt(to)) {
        for (std::size_t k = at; k < at + length; ++k)
          addTriangle({centre, border[k % n], border[(k + 1) % n]}, crossing);
      } else if (!isRebuilt(from)) {
        addTriangle({centre, border[at], chordAt_.at({crossing, side})}, crossing);
      } else if (!isRebuilt(to)) {
        addTriangle({centre, chordAt_.at({crossing, side}), border[(at + length) % n]}, crossing);
      }
    }
  }

  void addCell(const CellIndex& index, const RebuiltCell& cell) {
    std::vector<PatchRing> points;
    std::vector<std::int32_t> numbers;
    for (const CellRing& ring : cell.rings) {
      PatchRing to;
      Eigen::Vector3d mass = Eigen::Vector3d::Zero();
      for (std::size_t n = 0; n < ring.slots.size(); ++n) {
        const int slot = ring.slots[n];
        const std::uint32_t x = cell.crossings.crossing(slot);
        const std::int32_t chord = chordAt_.at({x, quadSide(slot >> 1, ring.faces[n])});
        for (const std::int32_t v : {crossingAt_.at(x), chord}) {
          numbers.push_back(v);
          to.points.push_back(mesh_.vertices[v]);
          mass += mesh_.vertices[v];
        }
        addStrip(index, cell, ring, n, chord);
      }
      mass /= static_cast<double>(to.points.size());
      to.vertices = {vertexOf(index, cell, ring).value_or(mass), mass};
      points.push_back(std::move(to));
    }
    const CellPatch patch =
        patchOf(cell.crossings, grid_.crossings.data(), cell.rings, points, cellBoxOf(index));
    for (std::size_t p = 0; p < patch.added.size(); ++p) {
      const CellRing& ring = cell.rings[patch.ringOf[p]];
      numbers.push_back(addVertex(patch.added[p], firstTime(cell, ring)));
    }
    for (std::size_t t = 0; t < patch.triangles.size(); ++t) {
      const Triangle& corners = patch.triangles[t];
      addTriangle({numbers[corners[0]], numbers[corners[1]], numbers[corners[2]]},
                  cell.crossings.crossing(patch.slotOf[t]));
    }
  }

  double firstTime(const RebuiltCell& cell, const CellRing& ring) const {
    double time = HUGE_VAL;
    for (const std::int8_t slot : ring.slots)
      time = std::min<double>(time, grid_.crossings[cell.crossings.crossing(slot)].timeSeconds);
    return time;
  }

  /// Returns the position of the ring's vertex in the original surface. Returns nothing if the ring
  /// had several vertices, or if its vertex does not lie inside the cell.
  std::optional<Eigen::Vector3d> vertexOf(const CellIndex& index, const RebuiltCell& cell,
                                          const CellRing& ring) const {
    std::int32_t vertex = -1;
    for (const std::int8_t slot : ring.slots) {
      const OldPolygon& polygon = polygons_.at(cell.crossings.crossing(slot));
      const std::int32_t own = polygon.vertex[quadCorner(slot >> 1)];
      if (vertex >= 0 && own != vertex) return {};
      vertex = own;
    }
    if (vertex < 0) return {};
    const Eigen::Vector3d local = cellBoxOf(index).toLocal(mesh_.vertices[vertex]);
    if (local.minCoeff() < kInside || local.maxCoeff() > 1 - kInside) return {};
    return mesh_.vertices[vertex];
  }

  /// Adds a triangle that ends a strip at a chord. If the two crossings of the chord have different
  /// vertices in the neighbouring cell, a strip joined these vertices to the vertices of this cell.
  /// The strip now ends at the chord.
  void addStrip(const CellIndex& index, const RebuiltCell& cell, const CellRing& ring,
                std::size_t n, std::int32_t chord) {
    const int face = ring.faces[n];
    if (cells_.contains(behindFace(index, face))) return;
    const auto vertexBehind = [&](int slot) {
      const int own = quadCorner(slot >> 1), side = quadSide(slot >> 1, face);
      const int other = own == side ? (side + 1) & 3 : side;
      return polygons_.at(cell.crossings.crossing(slot)).vertex[other];
    };
    const std::int32_t from = vertexBehind(ring.slots[n]),
                       to = vertexBehind(ring.slots[(n + 1) % ring.slots.size()]);
    if (from != to) addTriangle({chord, from, to}, Surface::kNoCrossing);
  }

  SelfIntersections findPairs() {
    std::vector<std::int32_t> added;
    for (std::size_t t = triangleCount_; t < mesh_.triangles.size(); ++t)
      added.push_back(static_cast<std::int32_t>(t));
    const TriangleBlocks blocks(mesh_, grid_.plan);
    std::vector<std::int32_t> near = blocks.near(mesh_, added, kReachCells);
    near.erase(std::remove_if(near.begin(), near.end(),
                              [&](std::int32_t t) {
                                return std::binary_search(removed_.begin(), removed_.end(), t);
                              }),
               near.end());
    return findNearPairs(mesh_, added, near, run_);
  }

  Surface& surface_;
  TriMesh& mesh_;
  const HermiteGrid& grid_;
  RunContext& run_;
  CellVertices cellVertices_;
  std::size_t vertexCount_, triangleCount_;  // sizes of the original surface
  std::set<CellIndex> cells_;
  std::map<CellIndex, RebuiltCell> rebuilt_;
  std::set<std::uint32_t> crossings_;  // all crossings of the rebuilt cells
  std::map<CellIndex, CellVertices::Range> ranges_;
  std::map<std::uint32_t, OldPolygon> polygons_;                   // by crossing
  std::map<std::uint32_t, std::int32_t> crossingAt_;               // crossing -> its vertex
  std::map<std::pair<std::uint32_t, int>, std::int32_t> chordAt_;  // crossing and side -> vertex
  std::vector<std::int32_t> removed_;                              // triangles, in ascending order
};

}  // namespace

SelfIntersections rebuildCells(Surface& surface, const HermiteGrid& grid,
                               const SelfIntersections& found, RunContext& run) {
  Rebuilder rebuilder(surface, grid, run);
  SelfIntersections pairs = found;
  for (int round = 0; round < kRebuildRounds && pairs.count > 0; ++round) {
    run.checkpoint(Phase::Check, static_cast<std::uint64_t>(round), kRebuildRounds);
    if (!rebuilder.addCells(pairs)) break;
    pairs = rebuilder.rebuild();
  }
  if (pairs.count >= found.count) {
    rebuilder.reset();
    return found;
  }
  rebuilder.dropRemoved(pairs);
  return pairs;
}

}  // namespace swept
