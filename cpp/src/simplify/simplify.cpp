// SPDX-License-Identifier: LGPL-2.1-or-later
#include "simplify/simplify.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "simplify/deviation.h"
#include "simplify/edge_collapse.h"
#include "simplify/feature_edges.h"

namespace swept {
namespace {

/// Of the tolerance: the tree's root mean square error; the rest is left to the edge collapse.
constexpr double kTreeFraction = 0.06;
/// Of the tolerance: limit of the samples; between the samples the surface may lie farther.
constexpr double kSampleFraction = 0.95;
/// Of the tolerance: what is measured may reach this; the rest is for points between the measured
/// ones.
constexpr double kMeasuredFraction = 0.85;
constexpr double kCreaseCut = 0.002;  ///< of the largest eigenvalue: a turn of some 5 degrees
constexpr int kRounds = 6;
constexpr int kCutTurns = 1;  ///< of splitting one node at a time; then down to the vertex
constexpr double kBaseTolerance = 0.02;  ///< cells
constexpr double kBaseAccepted = 0.03;   ///< cells: no second round for less
constexpr double kBaseCells = 0.08;      ///< tolerances from here on are cut from the base

/// One attempt to simplify: which vertices of the original must be left closer than others.
class Attempt {
 public:
  Attempt(const VertexTree& tree, const std::vector<Eigen::Vector3d>& points,
          const Triangles& triangles, const std::vector<std::uint8_t>& creased,
          const NearestTriangle& nearest, double tolerance)
      : tree_(tree),
        points_(points),
        triangles_(triangles),
        creased_(creased),
        nearest_(nearest),
        tolerance_(tolerance),
        blocked_(tree.nodes().size(), 0) {
    limit_.assign(points.size(), static_cast<float>(kSampleFraction * tolerance));
  }

  void run(const PairFinder& findPairs, RunContext& run) {
    const TreeCut cut = cutWithinLimits(run);
    treeTriangles_ = cut.triangles.size();
    mesh_.triangles = cut.triangles;
    mesh_.vertices.resize(cut.nodeOf.size());
    for (std::size_t v = 0; v < cut.nodeOf.size(); ++v) {
      const TreeNode& node = tree_.nodes()[cut.nodeOf[v]];
      mesh_.vertices[v] = {node.position, node.quadric, node.sample, points_[node.sample]};
    }
    takeSamples(cut);
    collapseEdges(mesh_, samples_, nearest_, tolerance_, run);
    measure(findPairs, run);
  }

  std::int64_t intersections() const { return static_cast<std::int64_t>(meeting_.size()); }
  double deviation() const { return deviation_.largest(); }
  std::size_t treeTriangles() const { return treeTriangles_; }
  const CollapseMesh& mesh() const { return mesh_; }

  /// Tightens the limits where the last run failed; `round` counts from 0.
  void tighten(int round) {
    std::vector<std::uint8_t> badVertex(mesh_.vertices.size(), 0);
    for (const std::int32_t t : deviation_.triangles) mark(t, badVertex);
    for (const auto& [s, t] : meeting_) {
      mark(s, badVertex);
      mark(t, badVertex);
    }
    const float factor = round < 2 ? 0.4f : 0.0f;
    const auto tightenVertex = [&](std::int32_t v, bool split) {
      limit_[v] *= factor;
      for (std::int32_t n = tree_.nodes()[v].parent; split && n >= 0 && !blocked_[n];
           n = tree_.nodes()[n].parent) {
        blocked_[n] = 1;
      }
    };
    for (std::size_t s = 0; s < samples_.triangle.size(); ++s) {
      for (const std::int32_t v : mesh_.triangles[samples_.triangle[s]]) {
        if (!badVertex[v]) continue;
        tightenVertex(source_[s], round >= 1);
        break;
      }
    }
    for (const std::int32_t v : deviation_.vertices) tightenVertex(v, true);
  }

 private:
  void mark(std::int32_t triangle, std::vector<std::uint8_t>& bad) const {
    for (const std::int32_t v : mesh_.triangles[triangle]) bad[v] = 1;
  }

  /// The tree's error is a mean; nodes with a vertex beyond its limit are split.
  TreeCut cutWithinLimits(RunContext& run) {
    for (int turn = 0;; ++turn) {
      TreeCut cut = cutTree(tree_, triangles_, kTreeFraction * tolerance_, blocked_, run);
      std::vector<std::uint8_t> bad(points_.size(), 0);
      const std::vector<std::int32_t> start = cornersOf(cut);
      parallelBlocks(points_.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t s = begin; s < end; ++s) {
          if (cut.node[s] == static_cast<std::int32_t>(s)) continue;
          double best = 1e300;
          for (std::int32_t c = start[cut.vertex[s]]; c < start[cut.vertex[s] + 1]; ++c) {
            const auto& t = cut.triangles[corners_[c]];
            best = std::min(best, squaredDistance(points_[s], position(cut, t[0]),
                                                  position(cut, t[1]), position(cut, t[2])));
          }
          bad[s] = best > static_cast<double>(limit_[s]) * limit_[s];
        }
      });
      bool any = false;
      for (std::size_t s = 0; s < bad.size(); ++s) {
        if (!bad[s]) continue;
        const std::int32_t node = cut.node[s];
        std::int32_t at = turn < kCutTurns ? node : tree_.nodes()[s].parent;
        for (; !blocked_[node]; at = tree_.nodes()[at].parent) blocked_[at] = 1;
        any = true;
      }
      if (!any) return cut;
    }
  }
  const Eigen::Vector3d& position(const TreeCut& cut, std::int32_t v) const {
    return tree_.nodes()[cut.nodeOf[v]].position;
  }
  /// Triangles by vertex: fills corners_, returns where each vertex starts.
  std::vector<std::int32_t> cornersOf(const TreeCut& cut) {
    std::vector<std::int32_t> start(cut.nodeOf.size() + 1, 0);
    for (const auto& t : cut.triangles) {
      for (const std::int32_t v : t) ++start[v];
    }
    exclusiveScan(start);
    corners_.resize(3 * cut.triangles.size());
    std::vector<std::int32_t> at = start;
    for (std::size_t t = 0; t < cut.triangles.size(); ++t) {
      for (const std::int32_t v : cut.triangles[t]) {
        corners_[at[v]++] = static_cast<std::int32_t>(t);
      }
    }
    return start;
  }

  /// One sample a node of the cut, with the tightest limit of its vertices; where the surface is
  /// not flat, middles of triangles and edges as well.
  void takeSamples(const TreeCut& cut) {
    samples_ = Samples{};
    source_.clear();
    std::vector<float> limit(cut.nodeOf.size(), 1e30f);
    for (std::size_t v = 0; v < limit_.size(); ++v) {
      float& l = limit[cut.vertex[v]];
      l = std::min(l, limit_[v]);
    }
    const auto add = [&](const Eigen::Vector3d& p, float l, std::int32_t vertex,
                         std::int32_t source) {
      samples_.points.push_back(p);
      samples_.limit.push_back(l);
      samples_.vertex.push_back(vertex);
      source_.push_back(source);
    };
    for (std::size_t v = 0; v < cut.nodeOf.size(); ++v) {
      const std::int32_t source = tree_.nodes()[cut.nodeOf[v]].sample;
      add(points_[source], limit[v], static_cast<std::int32_t>(v), source);
    }
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      if (!creased_[t]) continue;
      const auto& c = triangles_[t];
      Eigen::Vector3d middle = Eigen::Vector3d::Zero();
      float least = 1e30f;
      for (const std::int32_t v : c) {
        middle += points_[v] / 3;
        least = std::min(least, limit_[v]);
      }
      add(middle, least, cut.vertex[c[0]], c[0]);
      for (int k = 0; k < 3; ++k) {
        const std::int32_t u = c[k], v = c[(k + 1) % 3];
        if (u > v) continue;
        add((points_[u] + points_[v]) / 2, std::min(limit_[u], limit_[v]), cut.vertex[u], u);
      }
    }
  }

  void measure(const PairFinder& findPairs, RunContext& run) {
    run.checkpoint(Phase::Simplify, 3, 4);
    TriMesh result;
    result.triangles = mesh_.triangles;
    for (const CollapseVertex& v : mesh_.vertices) result.vertices.push_back(v.position);
    deviation_ =
        measureDeviation({points_, triangles_, creased_, nearest_, result.vertices,
                          result.triangles, tolerance_, std::min(samples_.largest, tolerance_)});
    run.checkpoint(Phase::Simplify, 7, 8);
    meeting_ = findPairs(result);
  }

  const VertexTree& tree_;
  const std::vector<Eigen::Vector3d>& points_;
  const Triangles& triangles_;
  const std::vector<std::uint8_t>& creased_;
  const NearestTriangle& nearest_;
  double tolerance_;
  std::vector<float> limit_;  ///< per original vertex
  std::vector<std::uint8_t> blocked_;
  std::vector<std::int32_t> corners_;
  Samples samples_;
  std::vector<std::int32_t> source_;  ///< per sample: an original vertex
  CollapseMesh mesh_;
  Deviation deviation_;
  std::vector<std::pair<std::int32_t, std::int32_t>> meeting_;
  std::size_t treeTriangles_ = 0;
};

}  // namespace

SimplifyTree::SimplifyTree(TriMesh mesh, std::vector<double> contactTime, const GridPlan& plan,
                           RunContext& run)
    : mesh_(std::move(mesh)), contactTime_(std::move(contactTime)), plan_(plan) {
  points_.reserve(mesh_.vertices.size());
  for (const auto& v : mesh_.vertices) points_.push_back((v - plan.origin) / plan.cell);
  run.checkpoint(Phase::Simplify);
  tree_.build(points_, mesh_.triangles, run);
  creased_.resize(mesh_.triangles.size());
  std::vector<std::uint8_t> bent(points_.size());
  parallelBlocks(bent.size(), 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      int rank = 0;
      tree_.nodes()[v].quadric.minimise(points_[v], kCreaseCut, rank);
      bent[v] = rank > 1;
    }
  });
  for (std::size_t t = 0; t < creased_.size(); ++t) {
    for (const std::int32_t v : mesh_.triangles[t]) creased_[t] |= bent[v];
  }
  nearest_ = std::make_unique<NearestTriangle>(points_, mesh_.triangles);
}

const SimplifyTree::Base& SimplifyTree::base(const PairFinder& findPairs, RunContext& run) const {
  const std::lock_guard lock(baseMutex_);
  if (base_.tree == nullptr) {
    Simplified cut =
        cutFromHere(kBaseTolerance * plan_.cell, kBaseAccepted * plan_.cell, findPairs, run);
    base_.tree =
        std::make_unique<SimplifyTree>(std::move(cut.mesh), std::move(cut.contactTime), plan_, run);
    base_.deviation = cut.deviation;
  }
  return base_;
}

Simplified SimplifyTree::cut(double tolerance, const PairFinder& findPairs, RunContext& run) const {
  if (tolerance < kBaseCells * plan_.cell) return cutFromHere(tolerance, 0, findPairs, run);
  const Base& from = base(findPairs, run);
  Simplified out = from.tree->cutFromHere(tolerance - from.deviation, 0, findPairs, run);
  out.deviation += from.deviation;
  return out;
}

Simplified SimplifyTree::cutFromHere(double tolerance, double accepted, const PairFinder& findPairs,
                                     RunContext& run) const {
  const double wanted = kMeasuredFraction * tolerance / plan_.cell;
  accepted = std::max(accepted / plan_.cell, wanted);
  Attempt attempt(tree_, points_, mesh_.triangles, creased_, *nearest_, wanted);
  Simplified out;
  for (int round = 0; round < kRounds; ++round) {
    attempt.run(findPairs, run);
    out.rounds = round + 1;
    if (attempt.deviation() <= accepted && attempt.intersections() == 0) break;
    if (round + 1 < kRounds) attempt.tighten(round);
  }
  out.treeTriangles = attempt.treeTriangles();
  if (attempt.deviation() > accepted) {
    out.mesh = mesh_;
    out.contactTime = contactTime_;
    out.featureEdges = featureEdges();
    return out;
  }
  out.deviation = attempt.deviation() * plan_.cell;
  out.mesh.triangles = attempt.mesh().triangles;
  for (const CollapseVertex& v : attempt.mesh().vertices) {
    const bool moved = v.position != points_[v.sample];
    out.mesh.vertices.push_back(moved ? plan_.origin + plan_.cell * v.position
                                      : mesh_.vertices[v.sample]);
    out.contactTime.push_back(contactTime_[v.sample]);
  }
  out.featureEdges = findFeatureEdges(out.mesh);
  return out;
}

std::vector<std::array<std::int32_t, 2>> SimplifyTree::featureEdges() const {
  return findFeatureEdges(mesh_);
}

}  // namespace swept
