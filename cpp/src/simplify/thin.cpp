// SPDX-License-Identifier: LGPL-2.1-or-later
#include "simplify/thin.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/parallel.h"
#include "geometry/half_edges.h"
#include "geometry/nearest_triangle.h"
#include "geometry/quadric.h"
#include "geometry/self_intersections.h"
#include "geometry/triangle_pairs.h"

namespace swept {
namespace {

using Eigen::Vector3d;
using Flags = std::vector<char>;

constexpr double kFirstFraction = 0.1;  // share of the limit in the first round

// Parameters of the thinning. They come from trials on a part with curved and plane faces (1.2
// million triangles: the fandisk test mesh moved over 16 keys), within 0.08 cells. The mesh for
// edge collapses gets a quarter of the triangles of the mesh for surface recognition. More rounds
// do not make it smaller.
struct Manner {
  int rounds = 3;
  double meanFraction = 1;  // share of the limit: largest root mean square distance from the planes
  double minCosine = 0.5;   // a triangle may turn by less than 60 degrees
  double minShape = 0.03;   // area vector / longest side squared
  double longest = 50;  // limit of a new edge's length, as a multiple of the mean edge of the input
  // Also compares new edges with the old triangles. Without this, a spike of 1.1 tolerances
  // remained on a scanned body (the bunny test mesh moved over 16 keys, 2 mm). Surface recognition
  // does not need it: surfaces are fitted to the vertices, and the solid is measured in the end.
  bool looksBack = true;
};
constexpr Manner kForCollapse;
constexpr Manner kForSurfaces{6, 0.35, 0.5, 0.15, 8, false};

constexpr int kMaxNeighbours = 40;
using Corners = std::array<std::int32_t, 3>;

// Buffers that a pass reuses.
struct Scratch {
  std::vector<Corners> fresh, nearby;
};

// Number of parallel parts; fixed, so that the result does not depend on the number of threads.
constexpr std::size_t kParts = 16;

class Thinner {
 public:
  /// `kept`: by vertex, 1 if it must stay.
  Thinner(const TriMesh& mesh, double limit, const Manner& manner, const Flags& kept, Phase phase,
          RunContext& run)
      : vertices_(mesh.vertices),
        limit_(limit),
        manner_(manner),
        kept_(kept),
        phase_(phase),
        run_(run),
        origin_(meanOf(mesh.vertices)),
        opposite_(std::move(findAdjacency(mesh).across)) {
    const std::size_t count = mesh.vertices.size();
    points_.reserve(count);
    for (const Vector3d& p : mesh.vertices) points_.push_back(p - origin_);
    vertex_.resize(opposite_.size());
    quadric_.resize(count);
    fan_.assign(count, -1);
    off_.assign(count, 0);
    into_.assign(count, -1);
    double sum = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto& tri = mesh.triangles[t];
      const Vector3d &a = points_[tri[0]], &b = points_[tri[1]], &c = points_[tri[2]];
      sum += (b - a).norm() + (c - b).norm() + (a - c).norm();
      const Vector3d area = (b - a).cross(c - a);
      const double twice = area.norm();
      Quadric plane;
      if (twice > 0) plane.addPlane(area / twice, a, twice);
      for (int k = 0; k < 3; ++k) {
        const auto h = static_cast<std::int32_t>(3 * t + k);
        vertex_[h] = tri[k];
        fan_[tri[k]] = h;
        quadric_[tri[k]] += plane;
      }
    }
    const double longest = manner_.longest * sum / static_cast<double>(opposite_.size());
    longest_ = longest * longest;
  }

  void work() {
    partOf_.resize(points_.size());
    for (std::size_t part = 0; part < kParts; ++part)
      std::fill(partOf_.begin() + firstOf(part), partOf_.begin() + firstOf(part + 1),
                static_cast<char>(part));
    for (int round = 0; round < manner_.rounds; ++round) {
      const double fraction =
          kFirstFraction * std::pow(1 / kFirstFraction, round / (manner_.rounds - 1.0));
      const double limit = fraction * limit_;
      findInner();
      parallelFor(kParts,
                  [&](std::size_t part) { pass(firstOf(part), firstOf(part + 1), limit, true); });
      pass(0, static_cast<std::int32_t>(points_.size()), limit, false);
    }
  }

  /// Returns the thinned mesh. `mesh` is the input mesh and supplies the positions.
  Thinned result(const TriMesh& mesh) const {
    Thinned out;
    std::vector<std::int32_t> id(points_.size(), -1);
    for (std::size_t t = 0; t < vertex_.size() / 3; ++t) {
      if (vertex_[3 * t] < 0) continue;
      std::array<std::int32_t, 3> corners{};
      for (int k = 0; k < 3; ++k) {
        const std::int32_t v = vertex_[3 * t + k];
        if (id[v] < 0) {
          id[v] = static_cast<std::int32_t>(out.source.size());
          out.source.push_back(v);
          out.mesh.vertices.push_back(mesh.vertices[v]);
        }
        corners[k] = id[v];
      }
      out.mesh.triangles.push_back(corners);
      out.triangle.push_back(static_cast<std::int32_t>(t));
    }
    return out;
  }

  /// Returns the remaining vertex into which `v` was merged, or `v` itself.
  std::int32_t heirOf(std::int32_t v) const {
    while (into_[v] >= 0) v = into_[v];
    return v;
  }

 private:
  static Vector3d meanOf(const std::vector<Vector3d>& points) {
    Vector3d sum = Vector3d::Zero();
    for (const Vector3d& p : points) sum += p;
    return sum / static_cast<double>(points.size());
  }

  // Returns the first vertex of a part: a range of vertex numbers, which follow the layers.
  std::int32_t firstOf(std::size_t part) const {
    return static_cast<std::int32_t>(part * points_.size() / kParts);
  }
  void findInner() {
    inner_.assign(points_.size(), 1);
    for (std::size_t h = 0; h < vertex_.size(); ++h) {
      const std::int32_t v = vertex_[h];
      if (v < 0) continue;
      const std::int32_t w = target(static_cast<std::int32_t>(h));
      if (partOf_[v] != partOf_[w]) inner_[v] = inner_[w] = 0;
    }
  }
  // Removes vertices in [begin, end); with `inner`, only those with all neighbours in their part.
  // Collapses in other parts do not touch their triangles, so all parts can run in parallel.
  void pass(std::int32_t begin, std::int32_t end, double limit, bool inner) {
    Scratch scratch;
    for (std::int32_t v = begin; v < end; ++v) {
      if ((v & 8191) == 0) run_.checkpoint(phase_);
      if (fan_[v] >= 0 && !kept_[v] && (inner_[v] != 0) == inner) removeIfClose(v, limit, scratch);
    }
  }

  // Returns the next half-edge that starts at the same vertex.
  std::int32_t turn(std::int32_t h) const {
    return static_cast<std::int32_t>(opposite_[previousHalfEdge(h)]);
  }
  std::int32_t target(std::int32_t h) const { return vertex_[nextHalfEdge(h)]; }

  // Merges vertex u into the neighbour with the smallest error, if that is within the limit.
  void removeIfClose(std::int32_t u, double limit, Scratch& scratch) {
    double best = manner_.meanFraction * manner_.meanFraction * limit * limit;
    std::int32_t chosen = -1;
    int neighbours = 0;
    std::int32_t h = fan_[u];
    do {
      const std::int32_t v = target(h);
      const double mean = quadric_[u].mean(points_[v]);
      if (mean < best) {
        best = mean;
        chosen = h;
      }
      if (++neighbours > kMaxNeighbours) return;
      h = turn(h);
    } while (h != fan_[u]);
    if (chosen >= 0 && mayCollapse(chosen, limit, scratch)) collapse(chosen);
  }

  int valence(std::int32_t v) const {
    int count = 0;
    std::int32_t h = fan_[v];
    do {
      ++count;
      h = turn(h);
    } while (h != fan_[v]);
    return count;
  }

  bool mayCollapse(std::int32_t edge, double limit, Scratch& scratch) {
    const std::int32_t v = target(edge);
    // The two ends must share exactly two neighbours. Each of these must keep three or more.
    std::array<std::int32_t, kMaxNeighbours> ring;
    std::int32_t h = fan_[v];
    auto end = ring.begin();
    do {
      if (end == ring.end()) return false;
      *end++ = target(h);
      h = turn(h);
    } while (h != fan_[v]);
    std::ptrdiff_t common = 0;
    h = edge;
    do {
      common += std::count(ring.begin(), end, target(h));
      h = turn(h);
    } while (h != edge);
    if (common != 2) return false;
    if (valence(vertex_[previousHalfEdge(edge)]) <= 3) return false;
    if (valence(vertex_[previousHalfEdge(opposite_[edge])]) <= 3) return false;
    double off = 0;
    if (!trianglesHold(edge, limit, off) || meetsNeighbours(edge, scratch)) return false;
    off_[v] = std::max(off_[v], off);
    return true;
  }

  // `off` receives how far the vertices merged into u may deviate from the new triangles.
  bool trianglesHold(std::int32_t edge, double limit, double& off) const {
    const std::int32_t u = vertex_[edge];
    const Vector3d &from = points_[u], &to = points_[target(edge)];
    double nearest = 1e300;
    for (std::int32_t h = turn(edge); h != edge; h = turn(h)) {
      const Vector3d &b = points_[target(h)], &c = points_[vertex_[previousHalfEdge(h)]];
      if (vertex_[previousHalfEdge(h)] == target(edge)) continue;
      const Vector3d before = (b - from).cross(c - from), after = (b - to).cross(c - to);
      const double area = after.norm();
      const double longest =
          std::max({(b - to).squaredNorm(), (c - to).squaredNorm(), (b - c).squaredNorm()});
      if (before.dot(after) < manner_.minCosine * before.norm() * area) return false;
      if (longest > longest_ || area < manner_.minShape * longest) return false;
      nearest = std::min(nearest, squaredDistance(from, to, b, c));
    }
    // Vertices merged into u earlier may already deviate by off_[u]; this collapse adds to it.
    if (manner_.looksBack) nearest = std::max(nearest, squaredRise(edge, limit));
    off = off_[u] + std::sqrt(nearest);
    return off <= limit;
  }

  // Returns whether visit(corners) is true for all triangles at v that do not touch u.
  template <class Visit>
  bool allAbout(std::int32_t v, std::int32_t u, const Visit& visit) const {
    std::int32_t h = fan_[v];
    do {
      const Corners c{v, target(h), vertex_[previousHalfEdge(h)]};
      if (c[1] != u && c[2] != u && !visit(c)) return false;
      h = turn(h);
    } while (h != fan_[v]);
    return true;
  }

  Vector3d areaOf(const Corners& c) const {
    return (points_[c[1]] - points_[c[0]]).cross(points_[c[2]] - points_[c[0]]);
  }

  // Whether a new triangle intersects a triangle that touches it. On a scanned body and on a part
  // with plane and curved faces, thinning produced only such pairs (50 to 90 per million
  // triangles). If all of them face the same way, no pair intersects.
  bool meetsNeighbours(std::int32_t edge, Scratch& scratch) const {
    const std::int32_t u = vertex_[edge], v = target(edge);
    scratch.fresh.clear();
    Vector3d mean = Vector3d::Zero();
    for (std::int32_t h = turn(edge); h != edge; h = turn(h)) {
      const Corners c{v, target(h), vertex_[previousHalfEdge(h)]};
      if (c[2] == v) continue;
      scratch.fresh.push_back(c);
      mean += areaOf(c);
    }
    const auto facesIt = [&](const Corners& c) { return areaOf(c).dot(mean) > 0; };
    bool plain =
        std::all_of(scratch.fresh.begin(), scratch.fresh.end(), facesIt) && allAbout(v, u, facesIt);
    for (std::int32_t h = turn(edge); plain && h != edge; h = turn(h))
      plain = allAbout(target(h), u, facesIt);
    if (plain) return false;
    scratch.nearby.clear();
    const auto take = [&](const Corners& c) {
      scratch.nearby.push_back(c);
      return true;
    };
    allAbout(v, u, take);
    for (std::int32_t h = turn(edge); h != edge; h = turn(h)) allAbout(target(h), u, take);
    for (std::size_t i = 0; i < scratch.fresh.size(); ++i) {
      const Corners& c = scratch.fresh[i];
      const auto meets = [&](const Corners& other) { return meetWrongly(vertices_, c, other); };
      if (std::any_of(scratch.nearby.begin(), scratch.nearby.end(), meets) ||
          std::any_of(scratch.fresh.begin() + i + 1, scratch.fresh.end(), meets))
        return true;
    }
    return false;
  }

  // Returns the largest squared distance of the middle of a new edge from the old triangles at u.
  double squaredRise(std::int32_t edge, double limit) const {
    const std::int32_t u = vertex_[edge];
    const Vector3d &from = points_[u], &to = points_[target(edge)];
    double rise = 0;
    for (std::int32_t h = turn(edge); h != edge && rise <= limit * limit; h = turn(h)) {
      const Vector3d middle = 0.5 * (to + points_[target(h)]);
      double least = 1e300;
      std::int32_t old = h;
      do {
        least = std::min(least, squaredDistance(middle, from, points_[target(old)],
                                                points_[vertex_[previousHalfEdge(old)]]));
        old = turn(old);
      } while (old != h && least > rise);
      rise = std::max(rise, least);
    }
    return rise;
  }

  void collapse(std::int32_t edge) {
    const std::int32_t u = vertex_[edge], v = target(edge),
                       back = static_cast<std::int32_t>(opposite_[edge]);
    quadric_[v] += quadric_[u];
    into_[u] = v;
    std::int32_t h = edge;
    do {
      const std::int32_t following = turn(h);
      vertex_[h] = v;
      h = following;
    } while (h != edge);
    for (const std::int32_t side : {edge, back}) {
      const std::uint32_t a = opposite_[nextHalfEdge(side)], b = opposite_[previousHalfEdge(side)];
      opposite_[a] = b;
      opposite_[b] = a;
      // Surviving half-edges replace those of the two removed triangles.
      fan_[vertex_[a]] = static_cast<std::int32_t>(a);
      fan_[vertex_[b]] = static_cast<std::int32_t>(b);
    }
    for (const std::int32_t side : {edge, back}) {
      for (int k = 0; k < 3; ++k) vertex_[side / 3 * 3 + k] = -1;
    }
    fan_[u] = -1;
  }

  const std::vector<Vector3d>& vertices_;
  double limit_;
  const Manner& manner_;
  const Flags& kept_;
  Phase phase_;
  RunContext& run_;
  Vector3d origin_;
  std::vector<Vector3d> points_;
  std::vector<std::int32_t> vertex_;  // by half-edge: its start vertex; -1: removed
  RawArray<std::uint32_t> opposite_;
  std::vector<std::int32_t> fan_;  // by vertex: a half-edge that starts there; -1: removed
  std::vector<Quadric> quadric_;
  std::vector<double> off_;         // by vertex: how far vertices merged into it may deviate
  std::vector<std::int32_t> into_;  // by vertex: the vertex into which it was merged; -1: none
  double longest_ = 0;              // longest edge allowed, in mm^2
  Flags partOf_;
  Flags inner_;  // by vertex: 1 if all its neighbours are in its own part
};

// Marks in `kept` the vertices of intersecting triangles and all vertices merged into them.
void keepAbout(const SelfIntersections& found, const Thinned& thinned, const Thinner& thinner,
               Flags& kept) {
  Flags meets(kept.size(), 0);
  const auto mark = [&](std::int32_t t) {
    for (const std::int32_t v : thinned.mesh.triangles[t]) meets[thinned.source[v]] = 1;
  };
  for (const auto& [first, second] : found.pairs) {
    mark(first);
    mark(second);
  }
  for (std::size_t v = 0; v < kept.size(); ++v) {
    if (meets[thinner.heirOf(static_cast<std::int32_t>(v))]) kept[v] = 1;
  }
}

}  // namespace

Thinned thinOut(const TriMesh& mesh, double limit, ThinFor purpose, Phase phase, RunContext& run,
                std::vector<char> kept) {
  const Manner& manner = purpose == ThinFor::Collapse ? kForCollapse : kForSurfaces;
  kept.resize(mesh.vertices.size(), 0);
  std::int64_t before = std::numeric_limits<std::int64_t>::max();
  for (;;) {
    Thinner thinner(mesh, limit, manner, kept, phase, run);
    thinner.work();
    Thinned thinned = thinner.result(mesh);
    const SelfIntersections found = findSelfIntersections(thinned.mesh, {}, run);
    // If the number of pairs no longer falls, the remaining pairs were in the input already.
    if (found.count == 0 || found.count >= before) return thinned;
    before = found.count;
    keepAbout(found, thinned, thinner, kept);
  }
}

}  // namespace swept
