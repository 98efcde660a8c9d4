// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/model/model.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "base/number_text.h"
#include "base/union_find.h"
#include "solid/carrier/section.h"
#include "solid/model/chains.h"
#include "solid/model/facet_edges.h"

namespace swept::step {
namespace {

using Eigen::Vector3d;

// Fraction of the tolerance: how far vertices of facets may move.
constexpr double kCornerFraction = 0.15;

class Builder {
 public:
  Builder(const HalfEdgeMesh& mesh, const Partition& partition, double tolerance, RunContext& run)
      : mesh_(mesh),
        partition_(partition),
        borders_(mesh, partition),
        tolerance_(tolerance),
        run_(run) {
    Chains found = findChains(mesh, partition, tolerance, run);
    chains_ = std::move(found.chains);
    kept_ = std::move(found.kept);
  }

  Model build() {
    moveVertices();
    run_.checkpoint(Phase::Export);
    dropShrunkChains();
    makeEdges();
    run_.checkpoint(Phase::Export);
    makeFaces();
    fitFacets();
    curveFacetEdges(model_);
    setTolerances();
    model_.positions = std::move(position_);
    return std::move(model_);
  }

 private:
  std::int32_t vertexAt(const Chain& chain, std::size_t i) const { return chain.vertex(mesh_, i); }

  // Moves each kept vertex to the point where the surfaces of its chains intersect, if this point
  // is near. A vertex of a facet moves the facet, too, so it may use only a small fraction of the
  // tolerance.
  void moveVertices() {
    position_ = mesh_.points;
    findFacetCorners();
    std::vector<std::vector<const Carrier*>> at(mesh_.points.size());
    std::vector<double> reach(mesh_.points.size(), 0);
    for (const Chain& chain : chains_) {
      for (std::size_t i = 0; i <= chain.halfEdges.size(); ++i) {
        const std::int32_t v = vertexAt(chain, i);
        if (!kept_[v]) continue;
        for (const Carrier* surface : chain.surfaces) {
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
      // Vertices without facets may move farther along their surfaces, from a jagged border to the
      // line of intersection.
      const double limit = isFacetCorner_[v] ? kCornerFraction * tolerance_
                                             : std::max(10 * tolerance_, 4 * reach[v]);
      const Vector3d moved = meetingPoint(mesh_.points[v], at[v]);
      if ((moved - mesh_.points[v]).norm() <= limit) position_[v] = moved;
    }
  }

  void findFacetCorners() {
    isFacetCorner_.assign(mesh_.points.size(), 0);
    for (std::size_t h = 0; h < mesh_.opposite.size(); ++h) {
      const auto half = static_cast<std::int32_t>(h);
      if (partition_.patches[borders_.patchOf(half)].surface.kind == CarrierKind::Facet)
        isFacetCorner_[mesh_.origin(half)] = 1;
    }
  }

  std::int32_t root(std::int32_t v) { return findRoot(same_, v); }

  // Jagged borders can meet in several vertices that belong to one corner of the solid. The chains
  // between these vertices shrink to a point and are dropped.
  void dropShrunkChains() {
    same_ = singleSets<std::int32_t>(mesh_.points.size());
    const double eps = std::max(1e-6, 0.02 * tolerance_);
    auto coincide = [&](std::int32_t a, std::int32_t b) {
      return a != b && (position_[a] - position_[b]).norm() <= eps;
    };
    std::erase_if(chains_, [&](const Chain& chain) {
      const std::int32_t a = vertexAt(chain, 0), b = vertexAt(chain, chain.halfEdges.size());
      if (!coincide(a, b) || chain.surfaces.size() < 2 || isFacetCorner_[a] || isFacetCorner_[b])
        return false;
      if (chain.halfEdges.size() > 12) return false;
      same_[root(a)] = root(b);
      return true;
    });
    // The remaining chains need distinct ends. Ends that coincide move back to their mesh
    // positions.
    for (int round = 0; round < 3; ++round) {
      for (const Chain& chain : chains_) {
        std::int32_t last = vertexAt(chain, 0);
        for (std::size_t i = 1; i <= chain.halfEdges.size(); ++i) {
          const std::int32_t v = vertexAt(chain, i);
          if (!kept_[v]) continue;
          if (coincide(root(last), root(v))) {
            position_[root(last)] = mesh_.points[last];
            position_[root(v)] = mesh_.points[v];
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
      model_.vertices.push_back({position_[v], 0});
    }
    return vertexId_[v];
  }

  // Returns the curve in which the two surfaces of a chain intersect, if both ends of the chain lie
  // on both surfaces.
  std::optional<Curve> exactCurveOf(const Chain& chain, const Vector3d& first,
                                    const Vector3d& last) const {
    for (const Carrier* surface : chain.surfaces) {
      for (const Vector3d& end : {first, last}) {
        if (std::abs(surface->distance(end)) > kOnCarrier) return std::nullopt;
      }
    }
    std::vector<Vector3d> along{first};
    double reach = 0;
    for (std::size_t i = 1; i <= chain.halfEdges.size(); ++i) {
      along.push_back(i == chain.halfEdges.size() ? last : mesh_.points[vertexAt(chain, i)]);
      reach = std::max(reach, (along[i] - along[i - 1]).norm());
    }
    const double maxDeviation = 3 * tolerance_ + 2 * reach;
    const Carrier &a = *chain.surfaces[0], &b = *chain.surfaces[1];
    const auto curve = sectionCurve(along, chain.closed, a, b, maxDeviation);
    return curve && isNear(*curve, along, chain, maxDeviation) ? curve : std::nullopt;
  }

  // Returns the curve in which the chain's surfaces intersect. If they are nearly parallel, returns
  // a curve along the mesh instead.
  Curve curveOf(const Chain& chain) {
    const std::size_t count = chain.halfEdges.size();
    const Vector3d first = position_[root(vertexAt(chain, 0))],
                   last = position_[root(vertexAt(chain, count))];
    if (const auto exact = exactCurveOf(chain, first, last)) return *exact;
    std::vector<Vector3d> along{first}, points{first};
    const bool profiled = std::any_of(chain.surfaces.begin(), chain.surfaces.end(),
                                      [](const Carrier* s) { return s->hasProfile(); });
    // A profile may bend between the few vertices that remain on its border, so more points are
    // used.
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

  // Returns whether the curve stays within the tolerance of its surfaces and near the mesh.
  bool isNear(const Curve& curve, const std::vector<Vector3d>& along, const Chain& chain,
              double limit) const {
    constexpr int kSteps = 32;
    double length = 0, meshLength = 0;
    Vector3d before = curve.at(0);
    for (int i = 0; i <= kSteps; ++i) {
      const Vector3d p = curve.at(curve.last * i / kSteps);
      length += (p - before).norm();
      before = p;
      for (const Carrier* surface : chain.surfaces) {
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

  // Splits a loop that passes a vertex twice into simple loops.
  void addSimpleLoops(const std::vector<ModelUse>& loop, ModelFace& face) {
    std::vector<ModelUse> open;
    std::unordered_map<std::int32_t, std::size_t> position;
    for (const ModelUse& use : loop) {
      const auto [it, isNew] = position.try_emplace(startOf(use), open.size());
      if (!isNew) {
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
      if (seen[first] || !borders_.isBorder(first)) continue;
      const std::int32_t patch = borders_.patchOf(first);
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
        h = borders_.next(h);
      } while (h != first);
      if (!loop.empty()) addSimpleLoops(loop, model_.faces[faceOf[patch]]);
    }
    model_.shellOwner = mesh_.shellOwner;
    std::erase_if(model_.faces, [](const ModelFace& face) { return face.loops.empty(); });
    std::stable_sort(model_.faces.begin(), model_.faces.end(),
                     [](const ModelFace& a, const ModelFace& b) { return a.shell < b.shell; });
  }

  // Recomputes the planes of facets, because their vertices may have moved onto other surfaces.
  void fitFacets() {
    for (ModelFace& face : model_.faces) {
      if (face.surface.kind != CarrierKind::Facet) continue;
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
          edge.tolerance = std::max(edge.tolerance, largestGap(edge.curve, face.surface));
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
  Borders borders_;
  double tolerance_;
  RunContext& run_;
  std::vector<Chain> chains_;
  std::vector<char> kept_;  // mesh vertices that become model vertices
  Model model_;
  std::vector<char> isFacetCorner_;     // for each mesh vertex, 1 if a facet uses it
  std::vector<std::int32_t> vertexId_;  // mesh vertex -> model vertex
  std::vector<std::int32_t> edgeOf_;    // half-edge -> model edge
  std::vector<char> isForward_;  // for each half-edge, 1 if it runs in the direction of its edge
  // For each half-edge, 1 if it is the first one along its edge, in its own direction.
  std::vector<char> startsEdge_;
  std::vector<Vector3d> position_;  // mesh vertex -> new position
  std::vector<std::int32_t> same_;  // union-find over mesh vertices that coincide
};

}  // namespace

Model buildModel(const HalfEdgeMesh& mesh, const Partition& partition, double tolerance,
                 RunContext& run) {
  return Builder(mesh, partition, tolerance, run).build();
}

std::string facesText(const std::vector<std::int32_t>& faces, const Model& model) {
  const auto& loops = model.faces[faces.front()].loops;
  const Vector3d at = model.vertices[model.edges[loops.front().front().edge].start].point;
  return textOf(6, counted(std::ssize(faces), "face"), " (the first at x = ", at.x(),
                ", y = ", at.y(), ", z = ", at.z(), " mm)");
}

}  // namespace swept::step
