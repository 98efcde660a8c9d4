// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/mend/surface_intersections.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "check/near_pairs.h"
#include "contour/mend/crowded_cells.h"
#include "contour/mend/polygons.h"
#include "contour/mend/region.h"
#include "geometry/triangle_pairs.h"

namespace swept {
namespace {

/// The centre of a fan may deviate from its lattice edge by this (cells), because of rounding.
constexpr double kOnEdge = 1e-9;
using Triangle = std::array<std::int32_t, 3>;

/// The lattice edge (axis, i, j, k) that a polygon surrounds.
struct PolygonEdge {
  int axis;
  Eigen::Vector3i low;
};

class PolygonSorter {
 public:
  PolygonSorter(const Surface& surface, const HermiteGrid& grid)
      : surface_(surface), grid_(grid), polygons_(surface, grid.crossings.size()) {}

  const Polygons& polygons() const { return polygons_; }

  /// Calls use(edge, crossing) for the polygons of one lattice layer.
  template <class Use>
  void forLayer(std::size_t i, const Use& use) const {
    const HermiteLayer& layer = grid_.layers[i];
    for (int axis = 0; axis < 3; ++axis) {
      for (std::size_t j = 0; j + 1 < layer.columnStart[axis].size(); ++j) {
        for (std::uint32_t e = layer.columnStart[axis][j]; e < layer.columnStart[axis][j + 1];
             ++e) {
          const HermiteEdge& crossed = layer.edges[axis][e];
          const PolygonEdge edge{axis, {static_cast<int>(i), static_cast<int>(j), crossed.k}};
          for (std::uint32_t c = crossed.first; c < crossed.first + (crossed.sides == 3 ? 2 : 1);
               ++c) {
            if (polygons_.has(c)) use(edge, c);
          }
        }
      }
    }
  }

  /// Returns true only if the polygon certainly lies in the tetrahedra of its own lattice edge.
  bool liesInTetrahedra(const PolygonEdge& edge, std::uint32_t crossing) const {
    const Polygon polygon = polygons_.of(crossing);
    return polygon.count == 2 ? quadLies(edge, polygons_.triangles(polygon))
                              : fanLies(edge, polygon);
  }

 private:
  bool inside(std::int32_t v) const {
    return (surface_.cellFlagsOf(v) & Surface::kInsideCell) != 0;
  }
  /// Does the test of liesInTetrahedra() for a fan, whose centre must lie on the lattice edge.
  bool fanLies(const PolygonEdge& edge, const Polygon& polygon) const {
    const Triangle* triangles = &surface_.mesh.triangles[polygon.first];
    const Eigen::Vector3d centre = local(edge, triangles[0][0]);
    if (centre.head<2>().cwiseAbs().maxCoeff() > kOnEdge) return false;
    if (centre[2] < kRounding || centre[2] > 1 - kRounding) return false;
    for (std::uint32_t t = 0; t < polygon.count; ++t) {
      if (triangles[t][0] != triangles[0][0]) return false;
      const int from = quadrant(edge, triangles[t][1]), to = quadrant(edge, triangles[t][2]);
      if (from < 0 || to < 0 || ((from ^ to) != 1 && (from ^ to) != 2)) return false;
    }
    return true;
  }

  bool quadLies(const PolygonEdge& edge, const Triangle* triangles) const {
    // The diagonal joins the two corners that both triangles share.
    const Triangle &p = triangles[0], &q = triangles[1];
    int third = 0;
    while (third < 3 && std::find(q.begin(), q.end(), p[third]) != q.end()) ++third;
    int fourth = 0;
    while (fourth < 3 && std::find(p.begin(), p.end(), q[fourth]) != p.end()) ++fourth;
    if (third == 3 || fourth == 3) return false;
    const std::int32_t a = p[(third + 1) % 3], c = p[(third + 2) % 3];
    const int qa = quadrant(edge, a), qc = quadrant(edge, c);
    const int qb = quadrant(edge, p[third]), qd = quadrant(edge, q[fourth]);
    if (std::min({qa, qb, qc, qd}) < 0 || (qa ^ qc) != 3 || (qb ^ qd) != 3 || qa == qb || qa == qd)
      return false;
    const Eigen::Vector3d from = local(edge, a), to = local(edge, c);
    const Passage b = passage(from, to, local(edge, p[third]));
    const Passage d = passage(from, to, local(edge, q[fourth]));
    // A diagonal that nearly meets the lattice edge may lie on either side of it.
    return b.inside || d.inside || (b.atEdge && d.atEdge);
  }

  /// Returns which of the four cells round the edge contains this vertex; -1 if none does, or if
  /// the vertex has left its own cell.
  int quadrant(const PolygonEdge& edge, std::int32_t v) const {
    if (!inside(v)) return -1;
    const Eigen::Vector3d x = local(edge, v);
    const bool near = std::abs(x[0]) < 1 - kRounding && std::abs(x[1]) < 1 - kRounding &&
                      x[2] > kRounding && x[2] < 1 - kRounding;
    return near ? (x[0] > 0 ? 1 : 0) + (x[1] > 0 ? 2 : 0) : -1;
  }

  /// Returns the position in cells, relative to the low end of the lattice edge. The last
  /// coordinate runs along the edge.
  Eigen::Vector3d local(const PolygonEdge& edge, std::int32_t v) const {
    const Eigen::Vector3d g =
        (surface_.mesh.vertices[v] - grid_.plan.origin) / grid_.plan.cell - edge.low.cast<double>();
    return {g[(edge.axis + 1) % 3], g[(edge.axis + 2) % 3], g[edge.axis]};
  }

  /// How a segment passes the triangle between the lattice edge and the point s: through its
  /// inside, or close to the edge.
  struct Passage {
    bool inside = false, atEdge = false;
  };
  static Passage passage(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                         const Eigen::Vector3d& s) {
    const double f = s[0] * from[1] - s[1] * from[0], t = s[0] * to[1] - s[1] * to[0];
    if (!(f * t < 0)) return {};
    const Eigen::Vector3d x = from + (to - from) * (f / (f - t));
    const double along = x.head<2>().dot(s.head<2>()) / s.head<2>().squaredNorm();
    constexpr double kNearEdge = 1e-5;
    return {along > kRounding && along < 1 - kRounding && x[2] > along * s[2] + kRounding &&
                x[2] < along * s[2] + (1 - along) - kRounding,
            std::abs(along) < kNearEdge && x[2] > 2 * kNearEdge && x[2] < 1 - 2 * kNearEdge};
  }

  const Surface& surface_;
  const HermiteGrid& grid_;
  Polygons polygons_;
};

/// Compares the triangles of each pair of polygons exactly. Returns the pairs of triangles that
/// intersect.
std::vector<std::pair<std::int32_t, std::int32_t>> compareEntangled(
    const Surface& surface, const Polygons& polygons, const CrossingPairs& entangled) {
  return gather<std::pair<std::int32_t, std::int32_t>>(
      entangled.size(), kTrianglesPerTask, [&](std::size_t n, auto& part) {
        const Polygon p = polygons.of(entangled[n].first);
        const Polygon q = polygons.of(entangled[n].second);
        for (std::uint32_t t = p.first; t < p.first + p.count; ++t) {
          for (std::uint32_t u = q.first; u < q.first + q.count; ++u) {
            const auto low = static_cast<std::int32_t>(std::min(t, u));
            const auto high = static_cast<std::int32_t>(std::max(t, u));
            if (trianglesIntersectFast(surface.mesh, low, high)) part.emplace_back(low, high);
          }
        }
      });
}

}  // namespace

SelfIntersections findSurfaceIntersections(const Surface& surface, const HermiteGrid& grid,
                                           RunContext& run, std::int64_t* unsure) {
  const PolygonSorter sorter(surface, grid);
  const std::size_t layers = grid.layers.size();
  std::vector<std::uint8_t> isCertain(grid.crossings.size(), 0);
  parallelFor(layers, [&](std::size_t i) {
    run.checkpoint(Phase::Check);
    sorter.forLayer(i, [&](const PolygonEdge& edge, std::uint32_t crossing) {
      isCertain[crossing] = sorter.liesInTetrahedra(edge, crossing);
    });
  });
  const CrossingPairs entangled =
      entangledPolygons(surface, grid, sorter.polygons(), isCertain, run);
  const std::vector<std::int32_t> members =
      gather<std::int32_t>(surface.mesh.triangles.size(), kTrianglesPerTask,
                           [&](std::size_t t, std::vector<std::int32_t>& part) {
                             const std::uint32_t crossing = surface.crossingOf[t];
                             if (crossing == Surface::kNoCrossing || isCertain[crossing] == 0)
                               part.push_back(static_cast<std::int32_t>(t));
                           });
  if (unsure != nullptr) *unsure = static_cast<std::int64_t>(members.size());
  // A polygon that lies in the tetrahedra of its own edge spans two cells. So every point of a
  // triangle is within this distance of its first corner.
  constexpr int kNearCells = 2;
  const TriangleBlocks blocks(surface.mesh, grid.plan);
  SelfIntersections found =
      findNearPairs(surface.mesh, members, blocks.near(surface.mesh, members, kNearCells), run);
  const auto more = compareEntangled(surface, sorter.polygons(), entangled);
  found.pairs.insert(found.pairs.end(), more.begin(), more.end());
  tbb::parallel_sort(found.pairs.begin(), found.pairs.end());
  found.count = static_cast<std::int64_t>(found.pairs.size());
  return found;
}

}  // namespace swept
