// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <string>
#include <unordered_map>

namespace swept::step {
namespace {

struct Chain {
  std::vector<std::int32_t> halfEdges;  // in order, all with the same patch on either side
  bool closed = false;
};

class Builder {
 public:
  Builder(const HalfEdgeMesh& mesh, const Partition& partition, double straightTolerance,
          RunContext& run)
      : mesh_(mesh), partition_(partition), tolerance_(straightTolerance), run_(run) {}

  Model build() {
    findBoundary();
    findChains();
    run_.checkpoint(Phase::Export);
    for (const Chain& chain : chains_) keepBends(chain);
    separateTwins();
    makeEdges();
    run_.checkpoint(Phase::Export);
    makeFaces();
    snapVertices();
    setTolerances();
    return std::move(model_);
  }

 private:
  std::int32_t patchOf(std::int32_t h) const { return partition_.patchOf[h / 3]; }
  bool isBoundary(std::int32_t h) const { return patchOf(h) != patchOf(mesh_.opposite[h]); }

  // The boundary half-edge of the same patch that follows h, turning within the fan of h.
  std::int32_t nextBoundary(std::int32_t h) const {
    std::int32_t n = HalfEdgeMesh::next(h);
    while (!isBoundary(n)) n = HalfEdgeMesh::next(mesh_.opposite[n]);
    return n;
  }

  void findBoundary() {
    degree_.assign(mesh_.points.size(), 0);
    const auto count = static_cast<std::int32_t>(mesh_.opposite.size());
    for (std::int32_t h = 0; h < count; ++h) {
      if (isBoundary(h)) ++degree_[mesh_.origin(h)];
    }
    kept_.assign(mesh_.points.size(), 0);
    for (std::size_t v = 0; v < degree_.size(); ++v) kept_[v] = degree_[v] > 2;
  }

  void findChains() {
    const auto count = static_cast<std::int32_t>(mesh_.opposite.size());
    std::vector<char> seen(count, 0);
    auto walk = [&](std::int32_t first) {
      Chain chain;
      std::int32_t h = first;
      do {
        seen[h] = seen[mesh_.opposite[h]] = 1;
        chain.halfEdges.push_back(h);
        if (kept_[mesh_.target(h)]) break;
        h = nextBoundary(h);
      } while (h != first);
      chain.closed = mesh_.origin(first) == mesh_.target(chain.halfEdges.back());
      chains_.push_back(std::move(chain));
    };
    for (std::int32_t h = 0; h < count; ++h) {
      if (!seen[h] && isBoundary(h) && kept_[mesh_.origin(h)]) walk(h);
    }
    for (std::int32_t h = 0; h < count; ++h) {
      if (!seen[h] && isBoundary(h)) walk(h);
    }
  }

  std::int32_t vertexAt(const Chain& chain, std::size_t i) const {
    return i < chain.halfEdges.size() ? mesh_.origin(chain.halfEdges[i])
                                      : mesh_.target(chain.halfEdges.back());
  }

  std::size_t farthest(const Chain& chain, std::size_t from, std::size_t to,
                       double& distance) const {
    const Eigen::Vector3d a = mesh_.points[vertexAt(chain, from)];
    const Eigen::Vector3d ab = mesh_.points[vertexAt(chain, to)] - a;
    const double length2 = ab.squaredNorm();
    std::size_t best = from;
    distance = -1;
    for (std::size_t i = from + 1; i < to; ++i) {
      const Eigen::Vector3d d = mesh_.points[vertexAt(chain, i)] - a;
      const double t = length2 > 0 ? std::clamp(d.dot(ab) / length2, 0.0, 1.0) : 0.0;
      const double off = (d - t * ab).norm();
      if (off > distance) {
        distance = off;
        best = i;
      }
    }
    return best;
  }

  // Keeps the vertices that a polyline within the tolerance needs (iterative split at the
  // farthest).
  void keepBends(const Chain& chain) {
    const std::size_t last = chain.halfEdges.size();
    std::vector<std::pair<std::size_t, std::size_t>> spans;
    if (chain.closed) {
      double distance = 0;
      const std::size_t middle = farthest(chain, 0, last, distance);
      kept_[vertexAt(chain, 0)] = kept_[vertexAt(chain, middle)] = 1;
      // A closed line needs three corners at least, whatever the tolerance.
      const std::size_t third = middle > 1 ? farthest(chain, 0, middle, distance)
                                           : farthest(chain, middle, last, distance);
      kept_[vertexAt(chain, third)] = 1;
      const auto [low, high] = std::minmax({middle, third});
      spans = {{0, low}, {low, high}, {high, last}};
    } else {
      spans = {{0, last}};
    }
    while (!spans.empty()) {
      const auto [from, to] = spans.back();
      spans.pop_back();
      if (to - from < 2) continue;
      double distance = 0;
      const std::size_t split = farthest(chain, from, to, distance);
      if (distance <= tolerance_) continue;
      kept_[vertexAt(chain, split)] = 1;
      spans.push_back({from, split});
      spans.push_back({split, to});
    }
  }

  // Two straight edges between the same two vertices would enclose nothing: keep more of their
  // chains.
  void separateTwins() {
    for (bool again = true; again;) {
      again = false;
      std::unordered_map<std::uint64_t, std::pair<std::size_t, std::size_t>> seen;
      for (std::size_t c = 0; c < chains_.size(); ++c) {
        std::size_t from = 0;
        for (std::size_t i = 1; i <= chains_[c].halfEdges.size(); ++i) {
          if (!kept_[vertexAt(chains_[c], i)]) continue;
          const auto [low, high] =
              std::minmax({vertexAt(chains_[c], from), vertexAt(chains_[c], i)});
          const std::uint64_t key =
              (static_cast<std::uint64_t>(low) << 32U) | static_cast<std::uint32_t>(high);
          const auto [it, fresh] = seen.try_emplace(key, c, from);
          if (!fresh) {
            again = keepWithin(c, from) | keepWithin(it->second.first, it->second.second) | again;
          }
          from = i;
        }
      }
    }
  }

  // Keeps the farthest vertex between `from` and the next kept one; false if there is none.
  bool keepWithin(std::size_t c, std::size_t from) {
    std::size_t to = from + 1;
    while (!kept_[vertexAt(chains_[c], to)]) ++to;
    if (to - from < 2) return false;
    double distance = 0;
    kept_[vertexAt(chains_[c], farthest(chains_[c], from, to, distance))] = 1;
    return true;
  }

  std::int32_t modelVertex(std::int32_t v) {
    if (vertexId_.empty()) vertexId_.assign(mesh_.points.size(), -1);
    if (vertexId_[v] < 0) {
      vertexId_[v] = static_cast<std::int32_t>(model_.vertices.size());
      model_.vertices.push_back({mesh_.points[v], 0});
    }
    return vertexId_[v];
  }

  void makeEdges() {
    edgeOf_.assign(mesh_.opposite.size(), -1);
    for (const Chain& chain : chains_) {
      std::int32_t edge = -1;
      for (const std::int32_t h : chain.halfEdges) {
        if (edge < 0) {
          edge = static_cast<std::int32_t>(model_.edges.size());
          model_.edges.push_back({modelVertex(mesh_.origin(h)), -1, 0});
        }
        edgeOf_[h] = edge;
        edgeOf_[mesh_.opposite[h]] = edge;
        forward_.push_back(h);
        if (kept_[mesh_.target(h)]) {
          model_.edges[edge].end = modelVertex(mesh_.target(h));
          edge = -1;
        }
      }
    }
    isForward_.assign(mesh_.opposite.size(), 0);
    for (const std::int32_t h : forward_) isForward_[h] = 1;
  }

  std::int32_t startOf(const ModelUse& use) const {
    return use.forward ? model_.edges[use.edge].start : model_.edges[use.edge].end;
  }

  // Cuts a loop that passes a vertex twice into simple loops.
  void addSimpleLoops(const std::vector<ModelUse>& loop, ModelFace& face) {
    std::vector<ModelUse> open;
    for (const ModelUse& use : loop) {
      const std::int32_t start = startOf(use);
      const auto at = std::find_if(open.begin(), open.end(),
                                   [&](const ModelUse& u) { return startOf(u) == start; });
      if (at != open.end() && pinched_[start]) {
        face.loops.emplace_back(at, open.end());
        open.erase(at, open.end());
      }
      open.push_back(use);
    }
    face.loops.push_back(std::move(open));
  }

  void makeFaces() {
    pinched_.assign(model_.vertices.size(), 0);
    for (std::size_t v = 0; v < mesh_.points.size(); ++v) {
      if (!vertexId_.empty() && vertexId_[v] >= 0 && degree_[v] > 3) pinched_[vertexId_[v]] = 1;
    }
    std::vector<std::int32_t> faceOf(partition_.patches.size(), -1);
    std::vector<char> seen(mesh_.opposite.size(), 0);
    const auto count = static_cast<std::int32_t>(mesh_.opposite.size());
    for (std::int32_t first = 0; first < count; ++first) {
      if (seen[first] || !isBoundary(first) || !kept_[mesh_.origin(first)]) continue;
      const std::int32_t patch = patchOf(first);
      if (faceOf[patch] < 0) {
        faceOf[patch] = static_cast<std::int32_t>(model_.faces.size());
        model_.faces.emplace_back();
        model_.faces.back().surface = partition_.patches[patch].surface;
        model_.faces.back().shell = mesh_.shellOf[first / 3];
        model_.faces.back().patch = patch;
      }
      std::vector<ModelUse> loop;
      std::int32_t h = first;
      do {
        seen[h] = 1;
        if (loop.empty() || kept_[mesh_.origin(h)])
          loop.push_back({edgeOf_[h], isForward_[h] != 0});
        h = nextBoundary(h);
      } while (h != first);
      addSimpleLoops(loop, model_.faces[faceOf[patch]]);
    }
    model_.shellOwner = mesh_.shellOwner;
    std::stable_sort(model_.faces.begin(), model_.faces.end(),
                     [](const ModelFace& a, const ModelFace& b) { return a.shell < b.shell; });
    facesAt_.assign(model_.vertices.size(), {});
    for (std::size_t f = 0; f < model_.faces.size(); ++f) {
      for (const auto& loop : model_.faces[f].loops) {
        for (const ModelUse& use : loop)
          facesAt_[startOf(use)].push_back(static_cast<std::int32_t>(f));
      }
    }
  }

  // Moves a vertex onto the surfaces that meet there, as far as they determine it. Facets follow.
  void snapVertices() {
    const double limit = 10 * tolerance_;
    for (std::size_t v = 0; v < model_.vertices.size(); ++v) {
      Eigen::Vector3d point = model_.vertices[v].point;
      for (int round = 0; round < 4; ++round) {
        Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
        Eigen::Vector3d right = Eigen::Vector3d::Zero();
        for (const std::int32_t f : facesAt_[v]) {
          const Surface& surface = model_.faces[f].surface;
          if (surface.kind == SurfaceKind::Facet) continue;
          const Eigen::Vector3d n = surface.normal(point);
          normal += n * n.transpose();
          right -= n * surface.distance(point);
        }
        Eigen::JacobiSVD<Eigen::Matrix3d> svd(normal, Eigen::ComputeFullU | Eigen::ComputeFullV);
        // Below this the planes are nearly parallel and would send the vertex far along them.
        svd.setThreshold(1e-3);
        point += svd.solve(right);
      }
      if ((point - model_.vertices[v].point).norm() <= limit) model_.vertices[v].point = point;
    }
    for (ModelFace& face : model_.faces) {
      if (face.surface.kind != SurfaceKind::Facet) continue;
      const auto& loop = face.loops.front();
      Eigen::Vector3d area = Eigen::Vector3d::Zero();
      const Eigen::Vector3d base = model_.vertices[startOf(loop[0])].point;
      for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
        area += (model_.vertices[startOf(loop[i])].point - base)
                    .cross(model_.vertices[startOf(loop[i + 1])].point - base);
      }
      if (area.norm() > 0) face.surface.axis = area.normalized();
      face.surface.point = base;
    }
  }

  void setTolerances() {
    for (std::size_t v = 0; v < model_.vertices.size(); ++v) {
      for (const std::int32_t f : facesAt_[v]) {
        double& t = model_.vertices[v].tolerance;
        t = std::max(t, std::abs(model_.faces[f].surface.distance(model_.vertices[v].point)));
      }
    }
    for (ModelEdge& edge : model_.edges) {
      edge.tolerance =
          std::max(model_.vertices[edge.start].tolerance, model_.vertices[edge.end].tolerance);
    }
  }

  const HalfEdgeMesh& mesh_;
  const Partition& partition_;
  double tolerance_;
  RunContext& run_;
  Model model_;
  std::vector<std::int32_t> degree_;  // boundary edges per mesh vertex
  std::vector<char> kept_;            // mesh vertices that become model vertices
  std::vector<Chain> chains_;
  std::vector<std::int32_t> vertexId_;  // mesh vertex -> model vertex
  std::vector<std::int32_t> edgeOf_;    // half-edge -> model edge
  std::vector<std::int32_t> forward_;
  std::vector<char> isForward_;
  std::vector<char> pinched_;  // model vertices with more than three boundary edges
  std::vector<std::vector<std::int32_t>> facesAt_;
};

}  // namespace

Model buildModel(const HalfEdgeMesh& mesh, const Partition& partition, double straightTolerance,
                 RunContext& run) {
  return Builder(mesh, partition, straightTolerance, run).build();
}

}  // namespace swept::step
