// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sampling/dense/candidates.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "base/sort_unique.h"
#include "geometry/mesh_parts.h"
#include "sampling/dense/dense_sampler.h"

namespace swept::dense {
namespace {

constexpr std::size_t kBlock = 256;  // vertices per task
/// Cosine of 1.1 degrees: of several normals within this angle, only one is queried.
constexpr double kMinSameCosine = 0.9998;
// Largest numbers of queries per vertex, and of halvings of an arc between two normals. They bound
// the time per vertex. leak_repair.h finds and adds the pairs that these limits miss.
constexpr std::size_t kMaxNormals = 8;
constexpr int kArcDepth = 3;

using Set = std::vector<std::uint32_t>;

void insert(Set& set, std::uint32_t placement) {
  const auto at = std::lower_bound(set.begin(), set.end(), placement);
  if (at == set.end() || *at != placement) set.insert(at, placement);
}

/// A query at a vertex, and the largest advance found.
struct Query {
  Point6 gradient;
  float best;
};

class CandidateSearch {
 public:
  CandidateSearch(const SamplerInput& input, const PlacementSpace& space,
                  const DenseSettings& settings, const ListsByKey<>& corners, RunContext& run)
      : input_(input),
        space_(space),
        settings_(settings),
        slack_(static_cast<float>(settings.slackCells * input.grid.cell + space.remainder())),
        corners_(corners),
        run_(run),
        vertices_(input.body.vertices.size()),
        normals_(vertices_, Eigen::Vector3d::Zero()),
        winners_(vertices_),
        queries_(vertices_) {
    setNormals();
  }

  FacePlacements find() {
    parallelBlocks(vertices_, kBlock, [&](std::size_t begin, std::size_t end) {
      run_.checkpoint(Phase::Sampling);
      for (std::size_t v = begin; v < end; ++v) queryAt(v);
    });
    queryAlongEdges();
    for (int ring = 0; ring < settings_.rings; ++ring) {
      if (!spread(ring < settings_.freeRings)) break;
    }
    return byFace();
  }

 private:
  void setNormals() {
    for (const auto& t : input_.body.triangles) {
      const Eigen::Vector3d twice = areaVector(input_.body, t);
      for (const std::int32_t v : t) normals_[v] += twice;
    }
    for (Eigen::Vector3d& normal : normals_) {
      const double length = normal.norm();
      normal = length > 0 ? Eigen::Vector3d(normal / length) : Eigen::Vector3d::UnitZ();
    }
  }

  std::uint32_t query(const Point6& g, std::uint32_t guess, float* advance = nullptr) const {
    const PlacementSpace::Best best = space_.support(g, guess);
    if (advance != nullptr) *advance = best.advance;
    return best.placement;
  }

  /// Queries normals on the arc between two (point, normal) pairs that have been queried already,
  /// by halving the arc. `winner` and `other`: the winners of the two pairs.
  void queryBetween(const Eigen::Vector3d& x, const Eigen::Vector3d& n, std::uint32_t winner,
                    const Eigen::Vector3d& y, const Eigen::Vector3d& m, std::uint32_t other,
                    int depth, Set& out) const {
    if (winner == other || depth == 0) return;
    Eigen::Vector3d between = n + m;
    const double length = between.norm();
    if (length < 0.2) return;  // nearly opposite normals have no arc between them
    between /= length;
    const Eigen::Vector3d z = (x + y) / 2;
    const std::uint32_t middle = query(space_.gradient(z, between), winner);
    insert(out, middle);
    queryBetween(x, n, winner, z, between, middle, depth - 1, out);
    queryBetween(z, between, middle, y, m, other, depth - 1, out);
  }

  void queryAt(std::size_t v) {
    const Eigen::Vector3d& x = input_.body.vertices[v];
    std::array<Eigen::Vector3d, kMaxNormals> queried;
    std::array<std::uint32_t, kMaxNormals> winnerOf{};
    std::size_t count = 0;
    const auto queryNormal = [&](const Eigen::Vector3d& n) {
      for (std::size_t i = 0; i < count; ++i) {
        if (queried[i].dot(n) > kMinSameCosine) return;
      }
      Query atVertex{space_.gradient(x, n), 0};
      winnerOf[count] = query(atVertex.gradient, count > 0 ? winnerOf[0] : 0, &atVertex.best);
      queried[count] = n;
      insert(winners_[v], winnerOf[count]);
      queries_[v].push_back(atVertex);
      ++count;
    };
    queryNormal(normals_[v]);
    for (const std::uint32_t corner : corners_.asTheyStand(v)) {
      if (count == kMaxNormals) break;
      queryNormal(input_.topology.normals[corner / 3].cast<double>());
    }
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = i + 1; j < count; ++j) {
        // The arc between the normals of two faces is queried only at a crease.
        if (i > 0 && queried[i].dot(queried[j]) > 0.9) continue;
        queryBetween(x, queried[i], winnerOf[i], x, queried[j], winnerOf[j], kArcDepth,
                     winners_[v]);
      }
    }
    queries_[v].shrink_to_fit();
  }

  /// Queries along the edges whose ends have different winners. The winners found in between are
  /// added to both ends.
  void queryAlongEdges() {
    const auto& edges = input_.topology.edges;
    std::vector<Set> found(edges.size());
    parallelBlocks(edges.size(), kBlock, [&](std::size_t begin, std::size_t end) {
      run_.checkpoint(Phase::Sampling);
      for (std::size_t e = begin; e < end; ++e) {
        const std::int32_t a = edges[e].a, b = edges[e].b;
        const std::uint32_t atA = query(queries_[a][0].gradient, winners_[a][0]);
        const std::uint32_t atB = query(queries_[b][0].gradient, winners_[b][0]);
        queryBetween(input_.body.vertices[a], normals_[a], atA, input_.body.vertices[b],
                     normals_[b], atB, kArcDepth, found[e]);
      }
    });
    for (std::size_t e = 0; e < edges.size(); ++e) {
      for (const std::uint32_t placement : found[e]) {
        insert(winners_[edges[e].a], placement);
        insert(winners_[edges[e].b], placement);
      }
    }
  }

  bool isNear(std::size_t v, std::uint32_t placement) const {
    const Point6& point = space_.point(placement);
    for (const Query& q : queries_[v]) {
      if (dot(q.gradient, point) >= q.best - slack_) return true;
    }
    return false;
  }

  /// Passes the winners of each vertex on to its neighbours: all of them with `freely`, otherwise
  /// those within the slack. Returns false if nothing changed.
  bool spread(bool freely) {
    if (fresh_.empty()) fresh_ = winners_;
    std::vector<Set> next(vertices_);
    std::vector<std::uint8_t> moved((vertices_ + kBlock - 1) / kBlock, 0);
    parallelBlocks(vertices_, kBlock, [&](std::size_t begin, std::size_t end) {
      run_.checkpoint(Phase::Sampling);
      Set offered;
      for (std::size_t v = begin; v < end; ++v) {
        offered.clear();
        for (const std::uint32_t corner : corners_.asTheyStand(v)) {
          for (const std::int32_t u : input_.body.triangles[corner / 3]) {
            if (static_cast<std::size_t>(u) == v) continue;
            offered.insert(offered.end(), fresh_[u].begin(), fresh_[u].end());
          }
        }
        sortUnique(offered);
        for (const std::uint32_t placement : offered) {
          if (winners_[v].size() + next[v].size() >= settings_.maxAtVertex) break;
          if (std::binary_search(winners_[v].begin(), winners_[v].end(), placement)) continue;
          if (freely || isNear(v, placement)) next[v].push_back(placement);
        }
        if (!next[v].empty()) moved[begin / kBlock] = 1;
      }
    });
    parallelBlocks(vertices_, kBlock, [&](std::size_t begin, std::size_t end) {
      for (std::size_t v = begin; v < end; ++v) {
        const auto middle = static_cast<std::ptrdiff_t>(winners_[v].size());
        winners_[v].insert(winners_[v].end(), next[v].begin(), next[v].end());
        std::inplace_merge(winners_[v].begin(), winners_[v].begin() + middle, winners_[v].end());
      }
    });
    fresh_ = std::move(next);
    return std::find(moved.begin(), moved.end(), 1) != moved.end();
  }

  FacePlacements byFace() const {
    const auto& triangles = input_.body.triangles;
    FacePlacements out;
    out.start.assign(triangles.size() + 1, 0);
    out.placement = gather<std::uint32_t>(triangles.size(), kBlock, [&](std::size_t f, Set& part) {
      Set both;
      for (const std::int32_t v : triangles[f]) {
        both.insert(both.end(), winners_[v].begin(), winners_[v].end());
      }
      sortUnique(both);
      out.start[f] = both.size();
      part.insert(part.end(), both.begin(), both.end());
    });
    exclusiveScan(out.start);
    return out;
  }

  const SamplerInput& input_;
  const PlacementSpace& space_;
  const DenseSettings& settings_;
  // mm: a winner is passed on if its advance is less than the best one by at most this.
  float slack_;
  const ListsByKey<>& corners_;
  RunContext& run_;
  std::size_t vertices_;
  std::vector<Eigen::Vector3d> normals_;
  std::vector<Set> winners_, fresh_;
  std::vector<std::vector<Query>> queries_;
};

}  // namespace

FacePlacements findCandidates(const SamplerInput& input, const PlacementSpace& space,
                              const DenseSettings& settings, const ListsByKey<>& corners,
                              RunContext& run) {
  return CandidateSearch(input, space, settings, corners, run).find();
}

}  // namespace swept::dense
