// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/mend/wall_sides.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <unordered_set>

#include "base/parallel.h"
#include "base/sort_unique.h"
#include "contour/mend/home_cell.h"

namespace swept {
namespace {

/// Smallest distance (cells) of a side from the middle of the wall, far above the rounding of
/// vertices.
constexpr double kMinHalfThickness = 2e-4;
/// Steps of directionAmong(); its error falls as 1 / sqrt(steps).
constexpr int kIterations = 200;

using Vec3 = Eigen::Vector3d;

bool sameCell(const Surface& surface, std::int32_t a, std::int32_t b) {
  if (a > b) std::swap(a, b);
  for (std::int32_t v = a; v < b; ++v) {
    if ((surface.cellFlags[v] & Surface::kSharedWithNext) == 0) return false;
  }
  return true;
}

TrianglesAround::const_iterator firstAt(const TrianglesAround& around, std::int32_t v) {
  return std::lower_bound(around.begin(), around.end(), std::pair(v, std::int32_t{-1}));
}

/// Returns the direction whose smallest scalar product with the normals is largest. This direction
/// points to the centre of the smallest ball that contains the end points of the normals (Badoiu
/// and Clarkson 2003).
Vec3 directionAmong(const std::vector<Vec3>& normals) {
  Vec3 middle = Vec3::Zero();
  for (const Vec3& n : normals) middle += n;
  middle /= static_cast<double>(normals.size());
  for (int turn = 1; turn <= kIterations; ++turn) {
    const Vec3* farthest = nullptr;
    double most = 0;
    for (const Vec3& n : normals) {
      const double distance = (n - middle).squaredNorm();
      if (distance <= most) continue;
      most = distance;
      farthest = &n;
    }
    if (farthest == nullptr || (turn == 1 && most < 0.5)) break;
    middle += (*farthest - middle) / (turn + 1);
  }
  return middle.normalized();
}

/// A lattice edge through the wall.
struct Through {
  Vec3 middle, across;  // cells: the point between its crossings; the vector from side a to side b
};

class WallGeometry {
 public:
  WallGeometry(const Surface& surface, const HermiteGrid& grid, const TrianglesAround& around)
      : surface_(surface), grid_(grid), around_(around) {}

  /// Returns all lattice edges through the wall. Returns none if the wall is thicker than
  /// `maxThickness` cells along any of them.
  std::vector<Through> throughWall(const WallSides& sides, double maxThickness) const {
    const std::vector<std::uint32_t> ofA = crossingsAt(surface_, around_, sides.a),
                                     ofB = crossingsAt(surface_, around_, sides.b);
    std::vector<Through> out;
    for (const std::uint32_t c : ofA) {
      for (const int step : {1, -1}) {
        const std::uint32_t other = c + static_cast<std::uint32_t>(step);
        if (!std::binary_search(ofB.begin(), ofB.end(), other)) continue;
        const CrossingEdge p = edgeOfCrossing(grid_, c), q = edgeOfCrossing(grid_, other);
        if (std::tie(p.axis, p.i, p.j, p.k) != std::tie(q.axis, q.i, q.j, q.k)) continue;
        const double from = grid_.crossings[c].fraction, to = grid_.crossings[other].fraction;
        Through edge;
        edge.middle = Vec3(p.i, p.j, p.k);
        edge.middle[p.axis] += (from + to) / 2;
        edge.across = Vec3::Unit(p.axis) * (to - from);
        if (std::abs(to - from) > maxThickness) return {};
        out.push_back(edge);
      }
    }
    return out;
  }

  Vec3 commonPoint(const WallSides& sides, const std::vector<Through>& edges) const {
    const auto& x = surface_.mesh.vertices;
    const Vec3 now = ((x[sides.a] + x[sides.b]) / 2 - grid_.plan.origin) / grid_.plan.cell;
    Vec3 mass = Vec3::Zero();
    for (const Through& edge : edges) mass += edge.middle;
    mass /= static_cast<double>(edges.size());
    return intoCell(now, homeCell(now, mass));
  }

  /// Returns half of the vector (cells) from a to b after the two are moved apart. Requires that
  /// both vertices lie at their common point.
  Vec3 halfOffset(const WallSides& sides, const std::vector<Through>& edges) const {
    std::vector<Vec3> normals;  // pointing into the wall from the side of a
    addNormals(sides.a, -1, normals);
    addNormals(sides.b, 1, normals);
    if (normals.empty()) return Vec3::Zero();
    const Vec3 direction = directionAmong(normals);
    double thickness = 0;
    for (const Through& edge : edges) thickness += std::abs(direction.dot(edge.across));
    thickness /= static_cast<double>(edges.size());
    return direction * std::min(std::max(thickness / 2, kMinHalfThickness), maxOffset(sides));
  }

 private:
  /// Returns half the distance from the common point of the two sides to the walls of its cell.
  double maxOffset(const WallSides& sides) const {
    const Vec3 at = (surface_.mesh.vertices[sides.a] - grid_.plan.origin) / grid_.plan.cell;
    const Vec3 local = at.array() - at.array().floor();
    return std::min(local.minCoeff(), 1 - local.maxCoeff()) / 2;
  }
  void addNormals(std::int32_t v, double sign, std::vector<Vec3>& out) const {
    for (auto at = firstAt(around_, v); at != around_.end() && at->first == v; ++at) {
      const auto& [p, q, r] = surface_.mesh.triangles[at->second];
      const auto& x = surface_.mesh.vertices;
      const Vec3 n = (x[q] - x[p]).cross(x[r] - x[p]);
      const double length = n.norm();
      if (length > 1e-12 * grid_.plan.cell * grid_.plan.cell) out.push_back(sign / length * n);
    }
  }

  const Surface& surface_;
  const HermiteGrid& grid_;
  const TrianglesAround& around_;
};

}  // namespace

std::vector<std::uint32_t> crossingsAt(const Surface& surface, const TrianglesAround& around,
                                       std::int32_t vertex) {
  std::vector<std::uint32_t> crossings;
  for (auto at = firstAt(around, vertex); at != around.end() && at->first == vertex; ++at) {
    crossings.push_back(surface.crossingOf[at->second]);
  }
  sortUnique(crossings);
  return crossings;
}

std::vector<WallSides> wallSides(const Surface& surface, const SelfIntersections& pairs) {
  const auto& triangles = surface.mesh.triangles;
  const auto crowded = [&](std::int32_t v) {
    return (surface.cellFlagsOf(v) & Surface::kShared) != 0;
  };
  std::vector<std::pair<std::int32_t, std::int32_t>> found;
  for (const auto& [t, u] : pairs.pairs) {
    for (const std::int32_t v : triangles[t]) {
      if (!crowded(v)) continue;
      for (const std::int32_t w : triangles[u]) {
        if (v == w || !crowded(w) || std::abs(v - w) > 12 || !sameCell(surface, v, w)) continue;
        found.emplace_back(std::min(v, w), std::max(v, w));
      }
    }
  }
  tbb::parallel_sort(found.begin(), found.end());
  std::vector<WallSides> out;
  std::unordered_set<std::int32_t> used;
  for (std::size_t n = 0; n < found.size(); ++n) {
    if (n > 0 && found[n] == found[n - 1]) continue;
    const auto [a, b] = found[n];
    if (used.contains(a) || used.contains(b)) continue;
    used.insert(a);
    used.insert(b);
    out.push_back({a, b});
  }
  return out;
}

void alignWallSides(Surface& surface, const HermiteGrid& grid, const std::vector<WallSides>& sides,
                    const TrianglesAround& around, double maxThickness) {
  const WallGeometry geometry(surface, grid, around);
  auto& x = surface.mesh.vertices;
  constexpr std::size_t kBlock = 64;
  const auto forAll = [&](const auto& use) {
    parallelBlocks(sides.size(), kBlock, [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n) use(n);
    });
  };
  std::vector<std::vector<Through>> edges(sides.size());
  forAll([&](std::size_t n) { edges[n] = geometry.throughWall(sides[n], maxThickness); });
  forAll([&](std::size_t n) {
    if (edges[n].empty()) return;
    x[sides[n].a] = x[sides[n].b] =
        grid.plan.origin + grid.plan.cell * geometry.commonPoint(sides[n], edges[n]);
  });
  std::vector<Vec3> halfOffset(sides.size(), Vec3::Zero());
  forAll([&](std::size_t n) {
    if (!edges[n].empty()) halfOffset[n] = grid.plan.cell * geometry.halfOffset(sides[n], edges[n]);
  });
  forAll([&](std::size_t n) {
    x[sides[n].a] -= halfOffset[n];
    x[sides[n].b] += halfOffset[n];
  });
}

}  // namespace swept
