// SPDX-License-Identifier: LGPL-2.1-or-later
#include "simplify/thin.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/parallel.h"
#include "geometry/nearest_triangle.h"
#include "geometry/quadric.h"
#include "geometry/self_intersections.h"
#include "geometry/triangle_pairs.h"
#include "simplify/folds.h"
#include "simplify/mapped_move.h"
#include "simplify/thin_parameters.h"
#include "simplify/triangle_fans.h"

namespace swept {
namespace {

using Eigen::Vector3d;
using Flags = std::vector<char>;

constexpr double kFirstFraction = 0.1;  // fraction of the limit that the first round uses

/// At the rim of a rod, every second merge makes a triangle slightly narrower, which later merges
/// make up for.
constexpr double kMinShapeKept = 0.5;
constexpr double kMinMove = 1e-3;  // smaller displacements (fraction of the limit) do not count

using Corners = TriangleFans::Corners;

// Buffers that a pass reuses.
struct Scratch {
  std::vector<Corners> fresh, nearby;
  std::vector<Vector3d> ring;
};

// Number of parallel parts; fixed, so that the result does not depend on the number of threads.
constexpr std::size_t kParts = 16;

class Thinner {
 public:
  /// `kept`: for each vertex, 1 if it must stay.
  Thinner(const TriMesh& mesh, double limit, const ThinParameters& parameters, const Flags& kept,
          Phase phase, RunContext& run)
      : vertices_(mesh.vertices),
        limit_(limit),
        parameters_(parameters),
        kept_(kept),
        phase_(phase),
        run_(run),
        origin_(meanOf(mesh.vertices)),
        fans_(mesh) {
    const std::size_t count = mesh.vertices.size();
    points_.reserve(count);
    for (const Vector3d& p : mesh.vertices) points_.push_back(p - origin_);
    quadric_.resize(count);
    deviation_.assign(count, 0);
    into_.assign(count, -1);
    if (parameters_.proven) moved_.assign(mesh.triangles.size(), 0);
    double sum = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto& tri = mesh.triangles[t];
      const Vector3d &a = points_[tri[0]], &b = points_[tri[1]], &c = points_[tri[2]];
      sum += (b - a).norm() + (c - b).norm() + (a - c).norm();
      const Vector3d area = (b - a).cross(c - a);
      const double twice = area.norm();
      Quadric plane;
      if (twice > 0) plane.addPlane(area / twice, a, twice);
      for (const std::int32_t v : tri) quadric_[v] += plane;
    }
    const double longest =
        parameters_.longest * sum / static_cast<double>(3 * mesh.triangles.size());
    longest_ = longest * longest;
  }

  void work() {
    partOf_.resize(points_.size());
    for (std::size_t part = 0; part < kParts; ++part)
      std::fill(partOf_.begin() + firstOf(part), partOf_.begin() + firstOf(part + 1),
                static_cast<char>(part));
    for (int round = 0; round < parameters_.rounds + parameters_.lastRounds; ++round) {
      const double progress = std::min(1.0, round / (parameters_.rounds - 1.0));
      const double limit = kFirstFraction * std::pow(1 / kFirstFraction, progress) * limit_;
      findInner();
      if (parameters_.proven) touched_.assign(moved_.size(), 0);
      parallelFor(kParts,
                  [&](std::size_t part) { pass(firstOf(part), firstOf(part + 1), limit, true); });
      pass(0, static_cast<std::int32_t>(points_.size()), limit, false);
    }
  }

  /// Returns the thinned mesh. `mesh` is the input mesh and supplies the positions.
  Thinned result(const TriMesh& mesh) const {
    Thinned out;
    std::vector<std::int32_t> id(points_.size(), -1);
    for (std::size_t t = 0; t < fans_.triangles(); ++t) {
      if (fans_.isGone(t)) continue;
      std::array<std::int32_t, 3> corners{};
      for (int k = 0; k < 3; ++k) {
        const std::int32_t v = fans_.start(static_cast<std::int32_t>(3 * t + k));
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
  std::int32_t remainingVertex(std::int32_t v) const {
    while (into_[v] >= 0) v = into_[v];
    return v;
  }

 private:
  static Vector3d meanOf(const std::vector<Vector3d>& points) {
    Vector3d sum = Vector3d::Zero();
    for (const Vector3d& p : points) sum += p;
    return sum / static_cast<double>(points.size());
  }

  // Returns the first vertex of a part. A part is a range of vertex numbers, which follow the
  // layers of the grid.
  std::int32_t firstOf(std::size_t part) const {
    return static_cast<std::int32_t>(part * points_.size() / kParts);
  }
  void findInner() {
    inner_.assign(points_.size(), 1);
    for (std::size_t n = 0; n < 3 * fans_.triangles(); ++n) {
      const auto h = static_cast<std::int32_t>(n);
      const std::int32_t v = fans_.start(h);
      if (v < 0) continue;
      const std::int32_t w = fans_.target(h);
      if (partOf_[v] != partOf_[w]) inner_[v] = inner_[w] = 0;
    }
  }
  // Removes vertices in [begin, end). With `inner`, removes only those whose neighbours are all in
  // their part. Collapses in other parts do not change the triangles of these vertices, so all
  // parts can run in parallel.
  void pass(std::int32_t begin, std::int32_t end, double limit, bool inner) {
    Scratch scratch;
    for (std::int32_t v = begin; v < end; ++v) {
      if ((v & 8191) == 0) run_.checkpoint(phase_);
      if (!fans_.wasMerged(v) && !kept_[v] && (inner_[v] != 0) == inner)
        removeIfClose(v, limit, scratch);
    }
  }

  // Merges vertex u into the neighbour with the smallest error, if this error is within the limit.
  void removeIfClose(std::int32_t u, double limit, Scratch& scratch) {
    double best = parameters_.meanFraction * parameters_.meanFraction * limit * limit;
    std::int32_t chosen = -1;
    int neighbours = 0;
    std::int32_t h = fans_.first(u);
    do {
      const std::int32_t v = fans_.target(h);
      const double mean = quadric_[u].mean(points_[v]);
      if (mean < best) {
        best = mean;
        chosen = h;
      }
      if (++neighbours > TriangleFans::kMaxNeighbours) return;
      h = fans_.turn(h);
    } while (h != fans_.first(u));
    if (chosen >= 0 && mayCollapse(chosen, limit, scratch)) collapse(chosen);
  }

  bool mayCollapse(std::int32_t edge, double limit, Scratch& scratch) {
    if (!fans_.staysManifold(edge)) return false;
    double deviation = 0;
    if (!newTrianglesFit(edge, limit, deviation)) return false;
    if (parameters_.proven) {
      deviation = provenMove(edge, scratch);
    } else if (parameters_.mapsFolds) {
      takeRing(edge, scratch.ring);
      if (isFolded(scratch.ring))
        deviation = std::max(deviation, deviation_[fans_.start(edge)] + mappedMove(scratch.ring));
    }
    if (deviation > limit || intersectsNeighbours(edge, scratch)) return false;
    double& before = deviation_[fans_.target(edge)];
    before = std::max(before, deviation);
    if (parameters_.proven) markMoved(edge, deviation);
    return true;
  }

  void markMoved(std::int32_t edge, double deviation) {
    std::int32_t h = edge;
    do {
      if (deviation > moved_[h / 3] + kMinMove * limit_) touched_[h / 3] = 1;
      moved_[h / 3] = deviation;
      h = fans_.turn(h);
    } while (h != edge);
  }

  // `ring` receives the neighbours of the start of `edge`, relative to it, as mappedMove() needs
  // them.
  void takeRing(std::int32_t edge, std::vector<Vector3d>& ring) const {
    const Vector3d& from = points_[fans_.start(edge)];
    ring.clear();
    std::int32_t h = edge;
    do {
      ring.push_back(points_[fans_.target(h)] - from);
      h = fans_.turn(h);
    } while (h != edge);
  }

  // Returns whether a triangle, before or after the collapse, is turned away from the mean of the
  // triangles around the vertex. There, points may lie near triangles that do not replace theirs.
  static bool isFolded(const std::vector<Vector3d>& ring) {
    const std::size_t count = ring.size();
    Vector3d mean = Vector3d::Zero();
    for (std::size_t k = 0; k < count; ++k) mean += ring[k].cross(ring[(k + 1) % count]);
    for (std::size_t k = 0; k < count; ++k) {
      const Vector3d &a = ring[k], &b = ring[(k + 1) % count];
      if (isFold(a.cross(b), mean)) return true;
      if (k > 0 && k + 1 < count && isFold((a - ring[0]).cross(b - ring[0]), mean)) return true;
    }
    return false;
  }

  // Returns how far the surface between the neighbours of u may deviate from the input mesh after
  // the collapse.
  double provenMove(std::int32_t edge, Scratch& scratch) const {
    takeRing(edge, scratch.ring);
    double before = 0;
    bool touched = false;
    std::int32_t h = edge;
    do {
      before = std::max(before, moved_[h / 3]);
      touched = touched || touched_[h / 3];
      h = fans_.turn(h);
    } while (h != edge);
    const double move = mappedMove(scratch.ring);
    return touched && move > kMinMove * limit_ ? HUGE_VAL : before + move;
  }

  // Returns whether the new triangles are acceptable. `deviation` receives how far the vertices
  // merged into u may deviate from them.
  bool newTrianglesFit(std::int32_t edge, double limit, double& deviation) const {
    const std::int32_t u = fans_.start(edge);
    const Vector3d &from = points_[u], &to = points_[fans_.target(edge)];
    double nearest = 1e300;
    for (std::int32_t h = fans_.turn(edge); h != edge; h = fans_.turn(h)) {
      const Vector3d &b = points_[fans_.target(h)], &c = points_[fans_.third(h)];
      if (fans_.third(h) == fans_.target(edge)) continue;
      const Vector3d before = (b - from).cross(c - from), after = (b - to).cross(c - to);
      const double area = after.norm();
      const double longest =
          std::max({(b - to).squaredNorm(), (c - to).squaredNorm(), (b - c).squaredNorm()});
      if (before.dot(after) < parameters_.minCosine * before.norm() * area) return false;
      if (longest > longest_) return false;
      if (area < parameters_.minShape * longest) {
        if (!parameters_.mayStayThin) return false;
        const double old =
            std::max({(b - from).squaredNorm(), (c - from).squaredNorm(), (b - c).squaredNorm()});
        if (area * old < kMinShapeKept * before.norm() * longest) return false;
      }
      nearest = std::min(nearest, squaredDistance(from, to, b, c));
    }
    // Vertices merged into u earlier may already deviate by deviation_[u]; this collapse adds to
    // their deviation.
    if (parameters_.testsNewEdges) nearest = std::max(nearest, squaredRise(edge, limit));
    deviation = deviation_[u] + std::sqrt(nearest);
    return deviation <= limit;
  }

  Vector3d areaOf(const Corners& c) const {
    return (points_[c[1]] - points_[c[0]]).cross(points_[c[2]] - points_[c[0]]);
  }

  // Returns whether a new triangle intersects a triangle with which it shares a vertex. On a
  // scanned body and on a part with plane and curved faces, thinning produced only such pairs (50
  // to 90 per million triangles). If all these triangles face the same way, no pair intersects.
  bool intersectsNeighbours(std::int32_t edge, Scratch& scratch) const {
    const std::int32_t v = fans_.target(edge);
    scratch.fresh.clear();
    Vector3d mean = Vector3d::Zero();
    for (std::int32_t h = fans_.turn(edge); h != edge; h = fans_.turn(h)) {
      const Corners c{v, fans_.target(h), fans_.third(h)};
      if (c[2] == v) continue;
      scratch.fresh.push_back(c);
      mean += areaOf(c);
    }
    const auto facesMean = [&](const Corners& c) { return areaOf(c).dot(mean) > 0; };
    bool facesAgree = std::all_of(scratch.fresh.begin(), scratch.fresh.end(), facesMean) &&
                      fans_.allBeside(edge, facesMean);
    for (std::int32_t h = fans_.turn(edge); facesAgree && h != edge; h = fans_.turn(h))
      facesAgree = fans_.allBeside(h, facesMean);
    if (facesAgree) return false;
    scratch.nearby.clear();
    const auto collect = [&](const Corners& c) {
      scratch.nearby.push_back(c);
      return true;
    };
    fans_.allBeside(edge, collect);
    for (std::int32_t h = fans_.turn(edge); h != edge; h = fans_.turn(h))
      fans_.allBeside(h, collect);
    for (std::size_t i = 0; i < scratch.fresh.size(); ++i) {
      const Corners& c = scratch.fresh[i];
      const auto intersects = [&](const Corners& other) {
        return trianglesIntersectFast(vertices_, c, other);
      };
      if (std::any_of(scratch.nearby.begin(), scratch.nearby.end(), intersects) ||
          std::any_of(scratch.fresh.begin() + i + 1, scratch.fresh.end(), intersects))
        return true;
    }
    return false;
  }

  // Returns the largest squared distance of the middle of a new edge from the old triangles at u.
  double squaredRise(std::int32_t edge, double limit) const {
    const std::int32_t u = fans_.start(edge);
    const Vector3d &from = points_[u], &to = points_[fans_.target(edge)];
    double rise = 0;
    for (std::int32_t h = fans_.turn(edge); h != edge && rise <= limit * limit; h = fans_.turn(h)) {
      const Vector3d middle = 0.5 * (to + points_[fans_.target(h)]);
      double least = 1e300;
      std::int32_t old = h;
      do {
        least = std::min(least, squaredDistance(middle, from, points_[fans_.target(old)],
                                                points_[fans_.third(old)]));
        old = fans_.turn(old);
      } while (old != h && least > rise);
      rise = std::max(rise, least);
    }
    return rise;
  }

  void collapse(std::int32_t edge) {
    const std::int32_t u = fans_.start(edge), v = fans_.target(edge);
    quadric_[v] += quadric_[u];
    into_[u] = v;
    fans_.merge(edge);
  }

  const std::vector<Vector3d>& vertices_;
  double limit_;
  const ThinParameters& parameters_;
  const Flags& kept_;
  Phase phase_;
  RunContext& run_;
  Vector3d origin_;
  std::vector<Vector3d> points_;
  TriangleFans fans_;
  std::vector<Quadric> quadric_;
  // For each vertex, how far (mm) vertices merged into it may deviate.
  std::vector<double> deviation_;
  // For each triangle, a bound on its distance from the input mesh. Only used if
  // ThinParameters::proven is set.
  std::vector<double> moved_;
  // For each triangle, 1 if it moved in this round. It may then not move again in this round: the
  // bounds of successive moves add up, and they grow least if each triangle moves once per round.
  Flags touched_;
  // For each vertex, the vertex into which it was merged; -1: none.
  std::vector<std::int32_t> into_;
  double longest_ = 0;  // squared length of the longest edge allowed, mm^2
  Flags partOf_;
  Flags inner_;  // for each vertex, 1 if all its neighbours are in its own part
};

// Marks in `kept` the vertices of intersecting triangles and all vertices merged into them.
void keepAround(const SelfIntersections& found, const Thinned& thinned, const Thinner& thinner,
                Flags& kept) {
  Flags intersects(kept.size(), 0);
  const auto mark = [&](std::int32_t t) {
    for (const std::int32_t v : thinned.mesh.triangles[t]) intersects[thinned.source[v]] = 1;
  };
  for (const auto& [first, second] : found.pairs) {
    mark(first);
    mark(second);
  }
  for (std::size_t v = 0; v < kept.size(); ++v) {
    if (intersects[thinner.remainingVertex(static_cast<std::int32_t>(v))]) kept[v] = 1;
  }
}

}  // namespace

Thinned thinOut(const TriMesh& mesh, double limit, ThinFor purpose, Phase phase, RunContext& run,
                std::vector<char> kept) {
  const ThinParameters parameters = parametersFor(purpose);
  kept.resize(mesh.vertices.size(), 0);
  std::int64_t before = std::numeric_limits<std::int64_t>::max();
  for (;;) {
    Thinner thinner(mesh, limit, parameters, kept, phase, run);
    thinner.work();
    Thinned thinned = thinner.result(mesh);
    const SelfIntersections found = findSelfIntersections(thinned.mesh, {}, run);
    // If the number of pairs no longer decreases, the input already had the remaining pairs.
    if (found.count == 0 || found.count >= before) return thinned;
    before = found.count;
    keepAround(found, thinned, thinner, kept);
  }
}

}  // namespace swept
