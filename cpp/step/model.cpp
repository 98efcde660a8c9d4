// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <unordered_map>

namespace swept::step {
namespace {

using Eigen::Vector3d;

// Planes at less than about two degrees do not fix the line in which they meet.
constexpr double kNearlyParallel = 0.9994;
constexpr double kCornerShare = 0.15;  // of the tolerance, for corners of facets

struct Chain {
  std::vector<std::int32_t> halfEdges;   // in order, all with the same patch on either side
  std::vector<const Surface*> surfaces;  // those that fix its points: not facets; a cut last
  bool closed = false;
  bool curved = false;    // one edge on the curve in which two surfaces meet
  bool straight = false;  // one edge on the line in which two planes meet
  bool dropped = false;   // shrank to a point
};

class Builder {
 public:
  Builder(const HalfEdgeMesh& mesh, const Partition& partition, double tolerance, RunContext& run)
      : mesh_(mesh), partition_(partition), tolerance_(tolerance), run_(run) {}

  Model build() {
    findBoundary();
    findChains();
    run_.checkpoint(Phase::Export);
    for (Chain& chain : chains_) classify(chain);
    for (const Chain& chain : chains_) {
      if (chain.curved) {
        kept_[vertexAt(chain, 0)] = 1;
      } else if (!chain.straight) {
        keepBends(chain);
      }
    }
    separateTwins();
    placeVertices();
    run_.checkpoint(Phase::Export);
    dropShrunkChains();
    makeEdges();
    run_.checkpoint(Phase::Export);
    makeFaces();
    fitFacets();
    setTolerances();
    model_.places = std::move(place_);
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
            if (keepWithin(c, from)) again = true;
            if (keepWithin(it->second.first, it->second.second)) again = true;
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

  // A chain between two recognised surfaces, one of them curved, runs on the curve in which they
  // meet.
  void classify(Chain& chain) {
    const Patch& left = partition_.patches[patchOf(chain.halfEdges[0])];
    const Patch& right = partition_.patches[patchOf(mesh_.opposite[chain.halfEdges[0]])];
    for (const Patch* patch : {&left, &right}) {
      if (patch->surface.kind != SurfaceKind::Facet) chain.surfaces.push_back(&patch->surface);
    }
    chain.curved =
        chain.surfaces.size() == 2 && !(left.surface.isPlanar() && right.surface.isPlanar());
    chain.straight = chain.surfaces.size() == 2 && !chain.curved && !chain.closed &&
                     left.surface.axis.dot(right.surface.axis) < kNearlyParallel;
    if (left.surfaceId >= 0 && left.surfaceId == right.surfaceId) {
      chain.surfaces = {&left.surface, nearestCut(chain, left.surfaceId)};
    }
  }

  const Surface* nearestCut(const Chain& chain, std::int32_t surfaceId) const {
    const Surface* best = nullptr;
    double least = 1e300;
    for (const Cut& cut : partition_.cuts) {
      if (cut.surfaceId != surfaceId) continue;
      double sum = 0;
      for (const std::int32_t h : chain.halfEdges) {
        sum += std::abs(cut.plane.distance(mesh_.points[mesh_.origin(h)]));
      }
      if (sum < least) {
        least = sum;
        best = &cut.plane;
      }
    }
    return best;
  }

  // Each kept vertex goes where the surfaces of its chains meet, if that is near. Beside a facet it
  // takes the facet's corner along, so there it may go only as far as the facets have left.
  void placeVertices() {
    place_ = mesh_.points;
    findFacetCorners();
    std::vector<std::vector<const Surface*>> at(mesh_.points.size());
    std::vector<double> reach(mesh_.points.size(), 0);
    for (const Chain& chain : chains_) {
      for (std::size_t i = 0; i <= chain.halfEdges.size(); ++i) {
        const std::int32_t v = vertexAt(chain, i);
        if (!kept_[v]) continue;
        for (const Surface* surface : chain.surfaces) {
          if (std::find(at[v].begin(), at[v].end(), surface) == at[v].end())
            at[v].push_back(surface);
        }
        const std::int32_t h = chain.halfEdges[std::min(i, chain.halfEdges.size() - 1)];
        reach[v] = std::max(reach[v],
                            (mesh_.points[mesh_.origin(h)] - mesh_.points[mesh_.target(h)]).norm());
      }
    }
    for (std::size_t v = 0; v < at.size(); ++v) {
      if (at[v].empty()) continue;
      if ((v & 4095U) == 0) run_.checkpoint(Phase::Export);
      // Elsewhere it slides along its surfaces, from a jagged border to the line where they meet.
      const double limit =
          isFacetCorner_[v] ? kCornerShare * tolerance_ : std::max(10 * tolerance_, 4 * reach[v]);
      const Vector3d moved = meetingPoint(mesh_.points[v], at[v]);
      if ((moved - mesh_.points[v]).norm() <= limit) place_[v] = moved;
    }
  }

  void findFacetCorners() {
    isFacetCorner_.assign(mesh_.points.size(), 0);
    for (std::size_t h = 0; h < mesh_.opposite.size(); ++h) {
      const auto half = static_cast<std::int32_t>(h);
      if (partition_.patches[patchOf(half)].surface.kind == SurfaceKind::Facet)
        isFacetCorner_[mesh_.origin(half)] = 1;
    }
  }

  std::int32_t root(std::int32_t v) {
    while (same_[v] != v) v = same_[v] = same_[same_[v]];
    return v;
  }

  // Jagged borders meet in several vertices that belong to one corner: their chains shrink to a
  // point.
  void dropShrunkChains() {
    same_.resize(mesh_.points.size());
    for (std::size_t v = 0; v < same_.size(); ++v) same_[v] = static_cast<std::int32_t>(v);
    const double eps = std::max(1e-6, 0.02 * tolerance_);
    auto coincide = [&](std::int32_t a, std::int32_t b) {
      return a != b && (place_[a] - place_[b]).norm() <= eps;
    };
    for (Chain& chain : chains_) {
      const std::int32_t a = vertexAt(chain, 0), b = vertexAt(chain, chain.halfEdges.size());
      if (!coincide(a, b) || chain.surfaces.size() < 2 || isFacetCorner_[a] || isFacetCorner_[b])
        continue;
      if (chain.halfEdges.size() > 12) continue;
      chain.dropped = true;
      same_[root(a)] = root(b);
    }
    // What is left needs its corners apart: these stay where the mesh has them.
    for (int round = 0; round < 3; ++round) {
      for (const Chain& chain : chains_) {
        if (chain.dropped) continue;
        std::int32_t last = vertexAt(chain, 0);
        for (std::size_t i = 1; i <= chain.halfEdges.size(); ++i) {
          const std::int32_t v = vertexAt(chain, i);
          if (!kept_[v]) continue;
          if (coincide(root(last), root(v))) {
            place_[root(last)] = mesh_.points[last];
            place_[root(v)] = mesh_.points[v];
          }
          last = v;
        }
      }
    }
  }

  std::int32_t modelVertex(std::int32_t v) {
    v = root(v);
    if (vertexId_.empty()) vertexId_.assign(mesh_.points.size(), -1);
    if (vertexId_[v] < 0) {
      vertexId_[v] = static_cast<std::int32_t>(model_.vertices.size());
      model_.vertices.push_back({place_[v], 0});
    }
    return vertexId_[v];
  }

  // The curve in which the surfaces of the chain meet; where they meet too flatly for that, a curve
  // along the mesh.
  Curve curveOf(const Chain& chain) {
    const std::size_t count = chain.halfEdges.size();
    const Vector3d first = place_[root(vertexAt(chain, 0))],
                   last = place_[root(vertexAt(chain, count))];
    std::vector<Vector3d> along{first}, points{first};
    const bool profiled = std::any_of(chain.surfaces.begin(), chain.surfaces.end(),
                                      [](const Surface* s) { return s->hasProfile(); });
    // A profile bends as it likes between the few vertices that its border has kept.
    const int between = profiled ? 1 + static_cast<int>(60 / count) : count < 8 ? 4 : 1;
    double reach = 0, moved = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const Vector3d a = i == 0 ? first : mesh_.points[vertexAt(chain, i)];
      const Vector3d b = i + 1 == count ? last : mesh_.points[vertexAt(chain, i + 1)];
      reach = std::max(reach, (b - a).norm());
      for (int k = 1; k <= between; ++k) {
        if (i + 1 == count && k == between) break;
        const double w = static_cast<double>(k) / between;
        along.push_back((1 - w) * a + w * b);
        points.push_back(meetingPoint(along.back(), chain.surfaces));
        moved = std::max(moved, (points.back() - along.back()).norm());
      }
    }
    along.push_back(last);
    points.push_back(last);
    const double eps = std::max(1e-6, 0.05 * tolerance_);
    if (moved <= 3 * tolerance_ + 2 * reach) {
      Curve curve = curveThrough(points, chain.closed, eps, chain.surfaces);
      if (isNear(curve, along, chain, 3 * tolerance_ + 2 * reach)) return curve;
    }
    return curveAlong(along, chain.closed, tolerance_);
  }

  // Within the tolerance of its surfaces, and nowhere far from the mesh.
  bool isNear(const Curve& curve, const std::vector<Vector3d>& along, const Chain& chain,
              double limit) const {
    constexpr int kSteps = 32;
    double length = 0, meshLength = 0;
    Vector3d before = curve.at(0);
    for (int i = 0; i <= kSteps; ++i) {
      const Vector3d p = curve.at(curve.last * i / kSteps);
      length += (p - before).norm();
      before = p;
      for (const Surface* surface : chain.surfaces) {
        if (std::abs(surface->distance(p)) > tolerance_) return false;
      }
      double nearest = 1e300;
      for (const Vector3d& q : along) nearest = std::min(nearest, (p - q).norm());
      if (nearest > limit) return false;
    }
    for (std::size_t i = 1; i < along.size(); ++i) meshLength += (along[i] - along[i - 1]).norm();
    return length <= 1.2 * meshLength + limit;
  }

  void makeEdges() {
    edgeOf_.assign(mesh_.opposite.size(), -1);
    isForward_.assign(mesh_.opposite.size(), 0);
    startsEdge_.assign(mesh_.opposite.size(), 0);
    std::size_t done = 0;
    for (const Chain& chain : chains_) {
      if ((++done & 63U) == 0) run_.checkpoint(Phase::Export);
      if (chain.dropped) continue;
      std::int32_t edge = -1;
      for (const std::int32_t h : chain.halfEdges) {
        if (edge < 0) {
          edge = static_cast<std::int32_t>(model_.edges.size());
          model_.edges.push_back({modelVertex(mesh_.origin(h)), -1, {}, 0});
          startsEdge_[h] = 1;
        }
        edgeOf_[h] = edge;
        edgeOf_[mesh_.opposite[h]] = edge;
        isForward_[h] = 1;
        const bool isLast = h == chain.halfEdges.back();
        if (isLast || (!chain.curved && kept_[mesh_.target(h)])) {
          startsEdge_[mesh_.opposite[h]] = 1;
          ModelEdge& made = model_.edges[edge];
          made.end = modelVertex(mesh_.target(h));
          made.curve = chain.curved ? curveOf(chain)
                                    : lineThrough(model_.vertices[made.start].point,
                                                  model_.vertices[made.end].point);
          edge = -1;
        }
      }
    }
  }

  std::int32_t startOf(const ModelUse& use) const {
    return use.forward ? model_.edges[use.edge].start : model_.edges[use.edge].end;
  }

  // Cuts a loop that passes a vertex twice into simple loops.
  void addSimpleLoops(const std::vector<ModelUse>& loop, ModelFace& face) {
    std::vector<ModelUse> open;
    std::unordered_map<std::int32_t, std::size_t> position;
    for (const ModelUse& use : loop) {
      const auto [it, fresh] = position.try_emplace(startOf(use), open.size());
      if (!fresh) {
        const std::size_t from = it->second;
        face.loops.emplace_back(open.begin() + static_cast<std::ptrdiff_t>(from), open.end());
        for (std::size_t i = from + 1; i < open.size(); ++i) position.erase(startOf(open[i]));
        open.resize(from);
      }
      open.push_back(use);
    }
    if (!open.empty()) face.loops.push_back(std::move(open));
  }

  void makeFaces() {
    std::vector<std::int32_t> faceOf(partition_.patches.size(), -1);
    std::vector<char> seen(mesh_.opposite.size(), 0);
    const auto count = static_cast<std::int32_t>(mesh_.opposite.size());
    for (std::int32_t first = 0; first < count; ++first) {
      if (seen[first] || !isBoundary(first)) continue;
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
        if (startsEdge_[h]) loop.push_back({edgeOf_[h], isForward_[h] != 0});
        h = nextBoundary(h);
      } while (h != first);
      if (!loop.empty()) addSimpleLoops(loop, model_.faces[faceOf[patch]]);
    }
    model_.shellOwner = mesh_.shellOwner;
    std::erase_if(model_.faces, [](const ModelFace& face) { return face.loops.empty(); });
    std::stable_sort(model_.faces.begin(), model_.faces.end(),
                     [](const ModelFace& a, const ModelFace& b) { return a.shell < b.shell; });
  }

  // Facets follow their corners, which may have been moved onto other surfaces.
  void fitFacets() {
    for (ModelFace& face : model_.faces) {
      if (face.surface.kind != SurfaceKind::Facet) continue;
      const auto& loop = face.loops.front();
      Vector3d area = Vector3d::Zero();
      const Vector3d base = model_.vertices[startOf(loop[0])].point;
      for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
        area += (model_.vertices[startOf(loop[i])].point - base)
                    .cross(model_.vertices[startOf(loop[i + 1])].point - base);
      }
      if (area.norm() > 0) face.surface.axis = area.normalized();
      face.surface.point = base;
    }
  }

  void setTolerances() {
    for (const ModelFace& face : model_.faces) {
      for (const auto& loop : face.loops) {
        for (const ModelUse& use : loop) {
          ModelEdge& edge = model_.edges[use.edge];
          // A straight edge in a plane is nowhere farther off than at its ends.
          const int steps = edge.curve.kind == CurveKind::Line && face.surface.isPlanar() ? 1 : 16;
          for (int i = 0; i <= steps; ++i) {
            const Vector3d p = edge.curve.at(edge.curve.last * i / steps);
            edge.tolerance = std::max(edge.tolerance, std::abs(face.surface.distance(p)));
          }
        }
      }
    }
    for (const ModelEdge& edge : model_.edges) {
      for (const bool atEnd : {false, true}) {
        ModelVertex& vertex = model_.vertices[atEnd ? edge.end : edge.start];
        const double gap = (edge.curve.at(atEnd ? edge.curve.last : 0) - vertex.point).norm();
        vertex.tolerance = std::max({vertex.tolerance, edge.tolerance, gap});
      }
    }
  }

  const HalfEdgeMesh& mesh_;
  const Partition& partition_;
  double tolerance_;
  RunContext& run_;
  Model model_;
  std::vector<std::int32_t> degree_;  // boundary edges per mesh vertex
  std::vector<char> kept_;            // mesh vertices that become model vertices
  std::vector<char> isFacetCorner_;   // mesh vertices that a facet uses
  std::vector<Chain> chains_;
  std::vector<std::int32_t> vertexId_;  // mesh vertex -> model vertex
  std::vector<std::int32_t> edgeOf_;    // half-edge -> model edge
  std::vector<char> isForward_;         // half-edge runs along its edge
  std::vector<char> startsEdge_;        // half-edge is the first of its edge in its own direction
  std::vector<Vector3d> place_;         // mesh vertex -> where it goes
  std::vector<std::int32_t> same_;      // union-find over mesh vertices that fall together
};

}  // namespace

Model buildModel(const HalfEdgeMesh& mesh, const Partition& partition, double tolerance,
                 RunContext& run) {
  return Builder(mesh, partition, tolerance, run).build();
}

}  // namespace swept::step
