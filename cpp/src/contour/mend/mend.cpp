// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/mend/mend.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <unordered_map>
#include <unordered_set>

#include "base/parallel.h"
#include "base/sort_unique.h"
#include "check/near_pairs.h"
#include "contour/mend/home_cell.h"
#include "contour/mend/region.h"
#include "contour/mend/wall_sides.h"
#include "geometry/exact_predicates.h"

namespace swept {
namespace {

// Largest number of rounds, to limit the time. Mending ends earlier if no pairs are left.
constexpr int kMendRounds = 8;
/// The first round aligns only the sides of walls up to this thickness (cells).
constexpr double kMaxFirstThickness = 0.1;
/// Distances (cells) by which a corner is moved away from the line through the others, tried in
/// turn. The first is just above rounding.
constexpr double kStepsAside[] = {1e-9, 1e-7, 1e-5, 1e-3};
/// A vertex moves back towards its first position by these fractions of the distance, tried in
/// turn.
constexpr double kReturnFractions[] = {1e-3, 1e-2, 0.1, 1};

using Triangle = std::array<std::int32_t, 3>;

/// Changes the surface in place, near the pairs of triangles that intersect at the start.
class Mender {
 public:
  Mender(Surface& surface, const HermiteGrid& grid, const SelfIntersections& found, RunContext& run)
      : surface_(surface),
        mesh_(surface.mesh),
        grid_(grid),
        run_(run),
        blocks_(mesh_, grid.plan),
        vertexCount_(mesh_.vertices.size()),
        pairs_(found) {
    marked_.resize(mesh_.vertices.size());
    region_ = nearPairs(nullptr);
  }

  /// Appends the moved and the new vertices to `surface_.mended`.
  void recordVertices() {
    std::vector<std::int32_t>& mended = surface_.mended;
    for (const auto& [v, position] : before_) mended.push_back(v);
    for (std::size_t v = vertexCount_; v < mesh_.vertices.size(); ++v)
      mended.push_back(static_cast<std::int32_t>(v));
    sortUnique(mended);
  }

  bool done() const { return pairs_.count == 0; }
  const SelfIntersections& left() const { return pairs_; }

  /// Gives area back to triangles whose corners were moved onto one point or line: their vertices
  /// move part of the way back. If this does not help, the corner opposite the longest side moves
  /// off the line by a tiny distance.
  void restoreAreas() {
    for (const double back : kReturnFractions) {
      std::vector<std::int32_t> vertices;
      for (const std::int32_t t : flatTriangles()) {
        vertices.insert(vertices.end(), mesh_.triangles[t].begin(), mesh_.triangles[t].end());
      }
      if (vertices.empty()) return;
      sortUnique(vertices);
      for (const std::int32_t v : vertices) {
        const auto at = before_.find(v);
        if (at != before_.end()) mesh_.vertices[v] += back * (at->second - mesh_.vertices[v]);
      }
      retestAround(vertices);
    }
    for (const double aside : kStepsAside) {
      std::vector<std::int32_t> vertices;
      for (const std::int32_t t : flatTriangles()) {
        if (!hasArea(t)) vertices.push_back(stepAside(mesh_.triangles[t], aside * grid_.plan.cell));
      }
      if (vertices.empty()) return;
      sortUnique(vertices);
      retestAround(vertices);
    }
  }

  void mendRound(int round) {
    std::vector<std::int32_t> polygons;  // each represented by one of its triangles
    std::vector<std::int32_t> vertices;
    for (const auto& [a, b] : pairs_.pairs) {
      for (const std::int32_t t : {a, b}) {
        if (surface_.crossingOf[t] != Surface::kNoCrossing) polygons.push_back(t);
        vertices.insert(vertices.end(), mesh_.triangles[t].begin(), mesh_.triangles[t].end());
      }
    }
    sortUnique(vertices);
    const std::vector<WallSides> facing = wallSides(surface_, pairs_);
    if (round >= 4) {  // later rounds include the polygons round the pairs' vertices
      for (const auto& [v, t] : trianglesAround(vertices, nearPairs(&region_))) {
        polygons.push_back(t);
      }
    }
    changed_.clear();
    fan(polygons);
    sortUnique(changed_);
    blocks_.update(mesh_, changed_);
    const std::vector<std::int32_t> near = nearPairs(&region_);
    if (round == 0) {
      vertices.erase(std::remove_if(vertices.begin(), vertices.end(),
                                    [&](std::int32_t v) { return canStay(v); }),
                     vertices.end());
    }
    const TrianglesAround around = trianglesAround(vertices, near);
    for (const std::int32_t v : vertices) before_.try_emplace(v, mesh_.vertices[v]);
    relax(vertices, around, round == 0 ? 0.5 : 1.0);
    // Where relaxing does not help, aligning the sides of a wall often does. This is done in every
    // other round.
    if (round % 2 == 0) {
      alignWallSides(surface_, grid_, facing, around, round == 0 ? kMaxFirstThickness : HUGE_VAL);
    }
    const std::vector<std::int32_t> moved = touching(vertices, near);
    changed_.insert(changed_.end(), moved.begin(), moved.end());
    sortUnique(changed_);
    blocks_.update(mesh_, changed_);
    retest(near);
  }

 private:
  std::vector<std::int32_t> nearPairs(const std::vector<std::int32_t>* among) const {
    std::vector<std::int32_t> members;
    for (const auto& [a, b] : pairs_.pairs) members.insert(members.end(), {a, b});
    return blocks_.near(mesh_, members, kReachCells, among);
  }

  /// Calls use(v, t, part) for each triangle t of `near` and each corner v of t that is in
  /// `vertices`. Returns all values that the calls append to `part`.
  template <class T, class Use>
  std::vector<T> forTouching(const std::vector<std::int32_t>& vertices,
                             const std::vector<std::int32_t>& near, const Use& use) {
    for (const std::int32_t v : vertices) marked_[v] = 1;
    std::vector<T> out =
        gather<T>(near.size(), kTrianglesPerTask, [&](std::size_t n, std::vector<T>& part) {
          for (const std::int32_t v : mesh_.triangles[near[n]]) {
            if (marked_[v] != 0) use(v, near[n], part);
          }
        });
    for (const std::int32_t v : vertices) marked_[v] = 0;
    return out;
  }
  std::vector<std::int32_t> touching(const std::vector<std::int32_t>& vertices,
                                     const std::vector<std::int32_t>& near) {
    using List = std::vector<std::int32_t>;
    return forTouching<std::int32_t>(
        vertices, near, [](std::int32_t, std::int32_t t, List& part) { part.push_back(t); });
  }
  TrianglesAround trianglesAround(const std::vector<std::int32_t>& vertices,
                                  const std::vector<std::int32_t>& near) {
    TrianglesAround out = forTouching<TrianglesAround::value_type>(
        vertices, near, [&](std::int32_t v, std::int32_t t, TrianglesAround& part) {
          if (surface_.crossingOf[t] != Surface::kNoCrossing) part.emplace_back(v, t);
        });
    tbb::parallel_sort(out.begin(), out.end());
    return out;
  }

  /// Moves component vertices towards their mass points.
  void relax(const std::vector<std::int32_t>& vertices, const TrianglesAround& around,
             double weight) {
    parallelBlocks(vertices.size(), 64, [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n) {
        const std::int32_t v = vertices[n];
        if (static_cast<std::size_t>(v) >= surface_.dualVertices) continue;
        const std::vector<std::uint32_t> crossings = crossingsAt(surface_, around, v);
        if (!crossings.empty()) relaxVertex(v, crossings, weight);
      }
    });
  }
  void relaxVertex(std::int32_t v, const std::vector<std::uint32_t>& crossings, double weight) {
    Eigen::Vector3d mass = Eigen::Vector3d::Zero();
    for (const std::uint32_t c : crossings) mass += crossingPoint(c);
    mass /= static_cast<double>(crossings.size());
    const Eigen::Vector3d now = (mesh_.vertices[v] - grid_.plan.origin) / grid_.plan.cell;
    mass = intoCell(mass, homeCell(now, mass));
    mesh_.vertices[v] = toWorld(now + weight * (mass - now));
  }

  /// Returns whether the vertex need not move because fans round it suffice: no other vertex shares
  /// its cell, and the vertex lies inside the cell.
  bool canStay(std::int32_t v) const {
    return static_cast<std::size_t>(v) >= surface_.dualVertices ||
           surface_.cellFlags[v] == Surface::kInsideCell;
  }

  bool hasArea(std::int32_t t) const {
    const Triangle& tri = mesh_.triangles[t];
    return !collinear(mesh_.vertices[tri[0]], mesh_.vertices[tri[1]], mesh_.vertices[tri[2]]);
  }
  Eigen::Vector3d toWorld(const Eigen::Vector3d& g) const {
    return grid_.plan.origin + grid_.plan.cell * g;
  }
  Eigen::Vector3d crossingPoint(std::uint32_t crossing) const {
    return positionOfCrossing(grid_, edgeOfCrossing(grid_, crossing), crossing);
  }

  void fan(std::vector<std::int32_t>& polygons) {
    const auto crossing = [&](std::int32_t t) { return surface_.crossingOf[t]; };
    std::sort(polygons.begin(), polygons.end(), [&](std::int32_t a, std::int32_t b) {
      return crossing(a) != crossing(b) ? crossing(a) < crossing(b) : a < b;
    });
    for (std::size_t n = 0; n < polygons.size(); ++n) {
      if (n == 0 || crossing(polygons[n]) != crossing(polygons[n - 1])) fanPolygon(polygons[n]);
    }
    marked_.resize(mesh_.vertices.size());
  }

  /// Replaces the polygon of triangle `t` by a fan about its crossing, unless the polygon is a fan
  /// already.
  void fanPolygon(std::int32_t t) {
    const std::uint32_t crossing = surface_.crossingOf[t];
    const auto same = [&](std::int32_t u) {
      return u >= 0 && static_cast<std::size_t>(u) < surface_.crossingOf.size() &&
             surface_.crossingOf[u] == crossing;
    };
    if (!fanned_.insert(crossing).second) return;
    while (same(t - 1)) --t;
    if (!same(t + 1) || same(t + 2)) return;  // only quads have two triangles
    auto& triangles = mesh_.triangles;
    // The ring consists of the directed edges whose reverse is not in the other triangle.
    std::vector<std::pair<std::int32_t, std::int32_t>> edges;
    for (const std::int32_t u : {t, t + 1}) {
      for (int c = 0; c < 3; ++c) edges.emplace_back(triangles[u][c], triangles[u][(c + 1) % 3]);
    }
    const auto inner = [&](const std::pair<std::int32_t, std::int32_t>& e) {
      return std::find(edges.begin(), edges.end(), std::pair(e.second, e.first)) != edges.end();
    };
    std::vector<std::pair<std::int32_t, std::int32_t>> rim;
    for (const auto& e : edges) {
      if (!inner(e)) rim.push_back(e);
    }
    if (rim.size() != 4) return;
    const auto centre = static_cast<std::int32_t>(mesh_.vertices.size());
    mesh_.vertices.push_back(toWorld(crossingPoint(crossing)));
    surface_.contactTime.push_back(grid_.crossings[crossing].timeSeconds);
    for (int e = 0; e < 4; ++e) {
      const Triangle triangle{rim[e].first, rim[e].second, centre};
      std::int32_t number = t + e;
      if (e < 2) {
        triangles[number] = triangle;
      } else {
        number = static_cast<std::int32_t>(triangles.size());
        triangles.push_back(triangle);
        surface_.crossingOf.push_back(crossing);
        region_.push_back(number);
      }
      changed_.push_back(number);
    }
  }

  std::vector<std::int32_t> flatTriangles() {
    std::vector<std::int32_t> flat = gather<std::int32_t>(
        region_.size(), kTrianglesPerTask, [&](std::size_t n, std::vector<std::int32_t>& part) {
          if (!hasArea(region_[n])) part.push_back(region_[n]);
        });
    sortUnique(flat);
    return flat;
  }

  /// Moves the corner opposite the longest side away from that side. Returns the corner.
  std::int32_t stepAside(const Triangle& triangle, double distance) {
    int longest = 0;
    Eigen::Vector3d side = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d other =
          mesh_.vertices[triangle[(k + 1) % 3]] - mesh_.vertices[triangle[k]];
      if (other.squaredNorm() <= side.squaredNorm()) continue;
      side = other;
      longest = k;
    }
    Eigen::Index axis = 0;
    side.cwiseAbs().minCoeff(&axis);
    const Eigen::Vector3d square = side.cross(Eigen::Vector3d::Unit(axis));
    const double length = square.norm();
    const std::int32_t corner = triangle[(longest + 2) % 3];
    mesh_.vertices[corner] +=
        distance * (length > 0 ? Eigen::Vector3d(square / length) : Eigen::Vector3d::UnitX());
    return corner;
  }

  void retestAround(const std::vector<std::int32_t>& vertices) {
    changed_ = touching(vertices, region_);
    sortUnique(changed_);
    blocks_.update(mesh_, changed_);
    retest(nearPairs(&region_));
  }

  /// Keeps the pairs of which neither triangle has changed, and tests all other pairs again.
  void retest(const std::vector<std::int32_t>& near) {
    std::vector<std::int32_t> candidates;
    candidates.reserve(near.size() + changed_.size());
    std::set_union(near.begin(), near.end(), changed_.begin(), changed_.end(),
                   std::back_inserter(candidates));
    const auto isChanged = [&](std::int32_t t) {
      return std::binary_search(changed_.begin(), changed_.end(), t);
    };
    SelfIntersections next = findNearPairs(mesh_, changed_, candidates, run_);
    for (const auto& pair : pairs_.pairs) {
      if (!isChanged(pair.first) && !isChanged(pair.second)) next.pairs.push_back(pair);
    }
    std::sort(next.pairs.begin(), next.pairs.end());
    next.count = static_cast<std::int64_t>(next.pairs.size());
    pairs_ = std::move(next);
  }

  Surface& surface_;
  TriMesh& mesh_;
  const HermiteGrid& grid_;
  RunContext& run_;
  TriangleBlocks blocks_;
  std::size_t vertexCount_;  // number of vertices before mending
  SelfIntersections pairs_;
  std::vector<std::int32_t> region_;   // triangles near the initial pairs
  std::vector<std::uint8_t> marked_;   // per vertex: 1 during a search for its triangles
  std::vector<std::int32_t> changed_;  // triangles changed in this round
  std::unordered_map<std::int32_t, Eigen::Vector3d> before_;  // first positions of moved vertices
  // Crossings whose polygons have been considered for fanning.
  std::unordered_set<std::uint32_t> fanned_;
};

}  // namespace

SelfIntersections mendSelfIntersections(Surface& surface, const HermiteGrid& grid,
                                        const SelfIntersections& found, RunContext& run) {
  if (found.count == 0) return found;
  Mender mender(surface, grid, found, run);
  for (int round = 0; round < kMendRounds && !mender.done(); ++round) {
    run.checkpoint(Phase::Check, static_cast<std::uint64_t>(round), kMendRounds);
    mender.mendRound(round);
  }
  mender.restoreAreas();
  mender.recordVertices();
  return mender.left();
}

}  // namespace swept
