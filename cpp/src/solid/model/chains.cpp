// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/model/chains.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "geometry/half_edges.h"
#include "solid/carrier/curve.h"

namespace swept::step {
namespace {

// Cosine of about two degrees. Two planes at a smaller angle do not determine a line of
// intersection reliably.
constexpr double kNearlyParallel = 0.9994;

class Finder {
 public:
  Finder(const HalfEdgeMesh& mesh, const Partition& partition, double tolerance)
      : mesh_(mesh), partition_(partition), borders_(mesh, partition), tolerance_(tolerance) {}

  Chains find(RunContext& run) {
    keepBranches();
    walkBorders();
    run.checkpoint(Phase::Export);
    for (Chain& chain : chains_) classify(chain);
    for (const Chain& chain : chains_) {
      if (chain.curved) {
        kept_[vertexAt(chain, 0)] = 1;
      } else if (!chain.straight) {
        keepBends(chain);
      }
    }
    separateTwins();
    return {std::move(chains_), std::move(kept_)};
  }

 private:
  // Keeps the vertices at which more than two border edges meet.
  void keepBranches() {
    std::vector<std::int32_t> degree(mesh_.points.size(), 0);
    const auto count = static_cast<std::int32_t>(mesh_.opposite.size());
    for (std::int32_t h = 0; h < count; ++h) {
      if (borders_.isBorder(h)) ++degree[mesh_.origin(h)];
    }
    kept_.assign(mesh_.points.size(), 0);
    for (std::size_t v = 0; v < degree.size(); ++v) kept_[v] = degree[v] > 2;
  }

  void walkBorders() {
    const auto count = static_cast<std::int32_t>(mesh_.opposite.size());
    std::vector<char> seen(count, 0);
    auto walk = [&](std::int32_t first) {
      Chain chain;
      std::int32_t h = first;
      do {
        seen[h] = seen[mesh_.opposite[h]] = 1;
        chain.halfEdges.push_back(h);
        if (kept_[mesh_.target(h)]) break;
        h = borders_.next(h);
      } while (h != first);
      chain.closed = mesh_.origin(first) == mesh_.target(chain.halfEdges.back());
      chains_.push_back(std::move(chain));
    };
    for (std::int32_t h = 0; h < count; ++h) {
      if (!seen[h] && borders_.isBorder(h) && kept_[mesh_.origin(h)]) walk(h);
    }
    for (std::int32_t h = 0; h < count; ++h) {
      if (!seen[h] && borders_.isBorder(h)) walk(h);
    }
  }

  std::int32_t vertexAt(const Chain& chain, std::size_t i) const { return chain.vertex(mesh_, i); }

  std::vector<Eigen::Vector3d> pointsOf(const Chain& chain) const {
    std::vector<Eigen::Vector3d> points;
    for (std::size_t i = 0; i <= chain.halfEdges.size(); ++i)
      points.push_back(mesh_.points[vertexAt(chain, i)]);
    return points;
  }

  // Keeps the vertices that a polyline needs to stay within the tolerance.
  void keepBends(const Chain& chain) {
    const std::size_t last = chain.halfEdges.size();
    const std::vector<Eigen::Vector3d> points = pointsOf(chain);
    std::vector<std::pair<std::size_t, std::size_t>> spans{{0, last}};
    std::vector<char> kept(points.size(), 0);
    if (chain.closed) {
      double distance = 0;
      const std::size_t middle = farthestPoint(points, 0, last, distance);
      // A closed line needs three corners, whatever the tolerance is.
      const std::size_t third = middle > 1 ? farthestPoint(points, 0, middle, distance)
                                           : farthestPoint(points, middle, last, distance);
      const auto [low, high] = std::minmax({middle, third});
      spans = {{0, low}, {low, high}, {high, last}};
      kept[0] = kept[low] = kept[high] = 1;
    }
    step::keepBends(points, std::move(spans), tolerance_, kept);
    for (std::size_t i = 0; i <= last; ++i) {
      if (kept[i]) kept_[vertexAt(chain, i)] = 1;
    }
  }

  // Two straight edges between the same two vertices would enclose no area. So more vertices of
  // their chains are kept.
  void separateTwins() {
    for (bool again = true; again;) {
      again = false;
      std::unordered_map<std::uint64_t, std::pair<std::size_t, std::size_t>> seen;
      for (std::size_t c = 0; c < chains_.size(); ++c) {
        std::size_t from = 0;
        for (std::size_t i = 1; i <= chains_[c].halfEdges.size(); ++i) {
          if (!kept_[vertexAt(chains_[c], i)]) continue;
          const auto key = edgeKey(vertexAt(chains_[c], from), vertexAt(chains_[c], i));
          const auto [it, isNew] = seen.try_emplace(key, c, from);
          if (!isNew) {
            if (keepWithin(c, from)) again = true;
            if (keepWithin(it->second.first, it->second.second)) again = true;
          }
          from = i;
        }
      }
    }
  }

  // Of the vertices of a chain between vertex `from` and the next kept vertex, keeps the one
  // farthest from the line between these two. Returns false if there is none.
  bool keepWithin(std::size_t c, std::size_t from) {
    std::size_t to = from + 1;
    while (!kept_[vertexAt(chains_[c], to)]) ++to;
    if (to - from < 2) return false;
    double distance = 0;
    kept_[vertexAt(chains_[c], farthestPoint(pointsOf(chains_[c]), from, to, distance))] = 1;
    return true;
  }

  // Marks a chain between two recognised surfaces. It is curved if at least one of them is curved,
  // and straight if both are planes that are not nearly parallel. The chain then becomes a piece of
  // the curve or line in which the two surfaces intersect.
  void classify(Chain& chain) {
    const Patch& left = partition_.patches[borders_.patchOf(chain.halfEdges[0])];
    const Patch& right = partition_.patches[borders_.patchOf(mesh_.opposite[chain.halfEdges[0]])];
    for (const Patch* patch : {&left, &right}) {
      if (patch->surface.kind != CarrierKind::Facet) chain.surfaces.push_back(&patch->surface);
    }
    chain.curved =
        chain.surfaces.size() == 2 && !(left.surface.isPlanar() && right.surface.isPlanar());
    chain.straight = chain.surfaces.size() == 2 && !chain.curved && !chain.closed &&
                     left.surface.axis.dot(right.surface.axis) < kNearlyParallel;
    if (left.surfaceId >= 0 && left.surfaceId == right.surfaceId) {
      chain.surfaces = {&left.surface, nearestCut(chain, left.surfaceId)};
    }
  }

  const Carrier* nearestCut(const Chain& chain, std::int32_t surfaceId) const {
    const Carrier* best = nullptr;
    double smallest = 1e300;
    for (const Cut& cut : partition_.cuts) {
      if (cut.surfaceId != surfaceId) continue;
      double sum = 0;
      for (const std::int32_t h : chain.halfEdges) {
        sum += std::abs(cut.plane.distance(mesh_.points[mesh_.origin(h)]));
      }
      if (sum < smallest) {
        smallest = sum;
        best = &cut.plane;
      }
    }
    return best;
  }

  const HalfEdgeMesh& mesh_;
  const Partition& partition_;
  Borders borders_;
  double tolerance_;
  std::vector<Chain> chains_;
  std::vector<char> kept_;
};

}  // namespace

Chains findChains(const HalfEdgeMesh& mesh, const Partition& partition, double tolerance,
                  RunContext& run) {
  return Finder(mesh, partition, tolerance).find(run);
}

}  // namespace swept::step
