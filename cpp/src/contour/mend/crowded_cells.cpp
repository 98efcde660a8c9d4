// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/mend/crowded_cells.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "base/lists_by_key.h"
#include "base/parallel.h"

namespace swept {
namespace {

using Triangle = std::array<std::int32_t, 3>;

bool isNew(const Triangle* triangles, std::uint32_t t, std::int32_t v) {
  return t == 0 || std::find(triangles[0].begin(), triangles[0].end(), v) == triangles[0].end();
}

/// Returns the crossings of the marked polygons round each vertex that shares its cell with others.
ListsByKey<> polygonsAround(const Surface& surface, const Polygons& polygons,
                            const std::vector<std::uint8_t>& marks) {
  return {surface.cellFlags.size(), [&](const auto& use) {
            parallelBlocks(marks.size(), 1 << 14, [&](std::size_t begin, std::size_t end) {
              for (std::size_t c = begin; c < end; ++c) {
                if (marks[c] == 0) continue;
                const auto crossing = static_cast<std::uint32_t>(c);
                const Polygon polygon = polygons.of(crossing);
                const Triangle* triangles = polygons.triangles(polygon);
                for (std::uint32_t t = 0; t < polygon.count; ++t) {
                  // Use each corner of the polygon once. All triangles of a fan begin with its
                  // centre, so in each only the second corner is new. The second triangle of a quad
                  // has one new corner.
                  for (int n = 0; n < 3; ++n) {
                    const std::int32_t v = triangles[t][n];
                    if ((surface.cellFlagsOf(v) & Surface::kShared) == 0) continue;
                    if (polygon.count > 2 ? n == 1 : isNew(triangles, t, v)) use(v, crossing);
                  }
                }
              }
            });
          }};
}

/// Searches for planes that separate the polygons of two vertices.
class PlaneSeparation {
 public:
  PlaneSeparation(const Surface& surface, const HermiteGrid& grid, const Polygons& polygons)
      : surface_(surface), grid_(grid), polygons_(polygons) {}

  /// Adds the pairs (a polygon of vertex A, a polygon of vertex B) that no tested plane separates.
  void find(std::span<const std::uint32_t> ofA, std::span<const std::uint32_t> ofB,
            std::int32_t origin, CrossingPairs& entangled) {
    const Eigen::Vector3d between = meanNormal(ofA) - meanNormal(ofB);
    origin_ = surface_.mesh.vertices[origin];
    separated_.assign(ofA.size() * ofB.size(), 0);
    std::size_t left = separated_.size();
    const auto part = [&](const Eigen::Vector3d& axis) { left -= separateBy(axis, ofA, ofB); };
    part(between);
    for (int axis = 0; axis < 3 && left > 0; ++axis) part(Eigen::Vector3d::Unit(axis));
    for (const auto& side : {ofA, ofB}) {
      for (std::size_t n = 0; n < side.size() && left > 0; ++n) part(normalOf(side[n]));
    }
    if (left == 0) return;
    for (std::size_t a = 0; a < ofA.size(); ++a) {
      for (std::size_t b = 0; b < ofB.size(); ++b) {
        if (separated_[a * ofB.size() + b] != 0) continue;
        entangled.emplace_back(std::min(ofA[a], ofB[b]), std::max(ofA[a], ofB[b]));
      }
    }
  }

 private:
  struct Range {
    double low = HUGE_VAL, high = -HUGE_VAL;
  };
  Eigen::Vector3d normalOf(std::uint32_t crossing) const {
    return grid_.crossings[crossing].normal.cast<double>();
  }
  Eigen::Vector3d meanNormal(std::span<const std::uint32_t> crossings) const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const std::uint32_t c : crossings) sum += normalOf(c);
    return sum / static_cast<double>(crossings.size());
  }
  /// Marks the pairs that a plane perpendicular to this axis separates; returns the number of new
  /// marks.
  std::size_t separateBy(const Eigen::Vector3d& axis, std::span<const std::uint32_t> ofA,
                         std::span<const std::uint32_t> ofB) {
    rangesOf(axis, ofA, rangesA_);
    rangesOf(axis, ofB, rangesB_);
    const double margin = kRounding * grid_.plan.cell * axis.cwiseAbs().sum();
    std::size_t found = 0, pair = 0;
    for (const Range& a : rangesA_) {
      for (const Range& b : rangesB_) {
        if (separated_[pair] == 0 && (a.low > b.high + margin || b.low > a.high + margin)) {
          separated_[pair] = 1;
          ++found;
        }
        ++pair;
      }
    }
    return found;
  }
  void rangesOf(const Eigen::Vector3d& axis, std::span<const std::uint32_t> crossings,
                std::vector<Range>& out) const {
    out.clear();
    for (const std::uint32_t c : crossings) {
      const Polygon polygon = polygons_.of(c);
      const Triangle* triangles = polygons_.triangles(polygon);
      Range range;
      for (std::uint32_t t = 0; t < polygon.count; ++t) {
        for (const std::int32_t v : triangles[t]) {
          const double along = axis.dot(surface_.mesh.vertices[v] - origin_);
          range.low = std::min(range.low, along);
          range.high = std::max(range.high, along);
        }
      }
      out.push_back(range);
    }
  }

  const Surface& surface_;
  const HermiteGrid& grid_;
  const Polygons& polygons_;
  Eigen::Vector3d origin_;
  std::vector<std::uint8_t> separated_;
  std::vector<Range> rangesA_, rangesB_;
};

bool shareVertex(const Surface& surface, const Polygon& p, const Polygon& q) {
  const auto& triangles = surface.mesh.triangles;
  for (std::uint32_t t = p.first; t < p.first + p.count; ++t) {
    for (const std::int32_t v : triangles[t]) {
      for (std::uint32_t u = q.first; u < q.first + q.count; ++u) {
        if (std::find(triangles[u].begin(), triangles[u].end(), v) != triangles[u].end()) {
          return true;
        }
      }
    }
  }
  return false;
}

/// Adds the two marked polygons of each lattice edge that has two, if they share a vertex.
void addFolded(const Surface& surface, const HermiteGrid& grid, const Polygons& polygons,
               const std::vector<std::uint8_t>& marks, std::vector<CrossingPairs>& parts) {
  const std::size_t first = parts.size();
  parts.resize(first + grid.layers.size());
  parallelFor(grid.layers.size(), [&](std::size_t i) {
    for (const auto& edges : grid.layers[i].edges) {
      for (const HermiteEdge& edge : edges) {
        if (edge.sides != 3 || marks[edge.first] == 0 || marks[edge.first + 1] == 0) continue;
        if (!shareVertex(surface, polygons.of(edge.first), polygons.of(edge.first + 1))) continue;
        parts[first + i].emplace_back(edge.first, edge.first + 1);
      }
    }
  });
}

}  // namespace

CrossingPairs entangledPolygons(const Surface& surface, const HermiteGrid& grid,
                                const Polygons& polygons, const std::vector<std::uint8_t>& marks,
                                RunContext& run) {
  constexpr std::size_t kBlock = 1 << 13;
  const auto& cellFlags = surface.cellFlags;
  ListsByKey<> around = polygonsAround(surface, polygons, marks);
  std::vector<CrossingPairs> parts(cellFlags.size() / kBlock + 1);
  parallelBlocks(cellFlags.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    run.checkpoint(Phase::Check);
    CrossingPairs& part = parts[begin / kBlock];
    PlaneSeparation separation(surface, grid, polygons);
    std::vector<std::span<const std::uint32_t>> lists;
    for (std::size_t first = begin; first < end; ++first) {
      if ((cellFlags[first] & Surface::kShared) != Surface::kSharedWithNext)
        continue;  // not the first vertex of its cell
      lists.clear();
      for (std::size_t v = first;; ++v) {
        lists.push_back(around.of(v));
        if ((cellFlags[v] & Surface::kSharedWithNext) == 0) break;
      }
      for (std::size_t b = 1; b < lists.size(); ++b) {
        for (std::size_t a = 0; a < b; ++a) {
          if (lists[a].empty() || lists[b].empty()) continue;
          separation.find(lists[a], lists[b], static_cast<std::int32_t>(first), part);
        }
      }
    }
  });
  addFolded(surface, grid, polygons, marks, parts);
  CrossingPairs all;
  for (const CrossingPairs& part : parts) all.insert(all.end(), part.begin(), part.end());
  tbb::parallel_sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

}  // namespace swept
