// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/model/facet_edges.h"

#include <array>
#include <cmath>

#include "solid/carrier/section.h"

namespace swept::step {
namespace {

using Eigen::Vector3d;

/// Fraction of the facet's angle at a vertex that a curve may use, because the other edge there may
/// bend inward, too.
constexpr double kMaxIntoCorner = 0.45;
/// rad; largest angle by which a curve may turn away from the facet. Edges of the curved face may
/// lie on that side.
constexpr double kMaxOutward = 0.4;
/// Largest distance of the curve from its chord, as a fraction of the length of the chord.
constexpr double kMaxStray = 0.3;

double angleAt(const Vector3d& corner, const Vector3d& a, const Vector3d& b) {
  return std::atan2((a - corner).cross(b - corner).norm(), (a - corner).dot(b - corner));
}

// Returns whether the curve from a to b stays away from the other two sides of the facet (a, b,
// apex) and from edges on its outer side. `into`: unit vector in the plane of the facet,
// perpendicular to the chord.
bool keepsClear(const Curve& curve, const Vector3d& a, const Vector3d& b, const Vector3d& apex,
                const Vector3d& into) {
  constexpr int kSteps = 16;
  const Vector3d along = (b - a).normalized();
  const double atA = kMaxIntoCorner * angleAt(a, b, apex),
               atB = kMaxIntoCorner * angleAt(b, a, apex);
  for (int i = 1; i < kSteps; ++i) {
    const Vector3d p = curve.at(curve.last * i / kSteps);
    const double height = (p - a).dot(into);
    const double fromA = std::atan2(height, (p - a).dot(along));
    const double fromB = std::atan2(height, (b - p).dot(along));
    if (fromA > atA || fromB > atB || fromA < -kMaxOutward || fromB < -kMaxOutward) return false;
  }
  return true;
}

struct Sides {
  std::array<std::int32_t, 2> face{-1, -1};
};

std::vector<Sides> sidesOf(const Model& model) {
  std::vector<Sides> sides(model.edges.size());
  for (std::size_t f = 0; f < model.faces.size(); ++f) {
    for (const auto& loop : model.faces[f].loops) {
      for (const ModelUse& use : loop)
        sides[use.edge].face[use.forward ? 0 : 1] = static_cast<std::int32_t>(f);
    }
  }
  return sides;
}

// Returns the vertex of a triangular facet opposite to the edge. Returns null if the face is not
// such a facet.
const Vector3d* apexOf(const Model& model, const ModelFace& face, const ModelEdge& edge) {
  if (face.surface.kind != CarrierKind::Facet || face.loops.size() != 1 ||
      face.loops.front().size() != 3)
    return nullptr;
  for (const ModelUse& use : face.loops.front()) {
    for (const std::int32_t v : {model.edges[use.edge].start, model.edges[use.edge].end}) {
      if (v != edge.start && v != edge.end) return &model.vertices[v].point;
    }
  }
  return nullptr;
}

}  // namespace

void curveFacetEdges(Model& model) {
  const std::vector<Sides> sides = sidesOf(model);
  for (std::size_t e = 0; e < model.edges.size(); ++e) {
    ModelEdge& edge = model.edges[e];
    if (edge.curve.kind != CurveKind::Line) continue;
    const auto& [left, right] = sides[e].face;
    if (left < 0 || right < 0) continue;
    const bool leftIsFacet = model.faces[left].surface.isPlanar();
    const ModelFace& facet = model.faces[leftIsFacet ? left : right];
    const ModelFace& bent = model.faces[leftIsFacet ? right : left];
    if (bent.surface.isPlanar() || !facet.surface.isPlanar()) continue;
    const Vector3d &a = model.vertices[edge.start].point, &b = model.vertices[edge.end].point;
    if (std::abs(bent.surface.distance(a)) > kOnCarrier ||
        std::abs(bent.surface.distance(b)) > kOnCarrier ||
        largestGap(edge.curve, bent.surface) <= kOnCarrier)
      continue;
    const Vector3d* apex = apexOf(model, facet, edge);
    if (apex == nullptr) continue;
    const auto curve =
        sectionCurve({a, b}, false, facet.surface, bent.surface, kMaxStray * (b - a).norm());
    const Vector3d across = facet.surface.axis.cross(b - a).normalized();
    const Vector3d into = across.dot(*apex - a) > 0 ? across : Vector3d(-across);
    if (curve && keepsClear(*curve, a, b, *apex, into)) edge.curve = *curve;
  }
}

}  // namespace swept::step
